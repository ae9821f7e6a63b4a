"""The form for 3D Slicer, filled in and pressed without Slicer: its widgets and nodes are stand-ins that remember what they are told,
nodes are files, and the program is ours. What Slicer itself draws stays untried."""
import importlib.util
import json
import pathlib
import shutil
import sys
import types

import numpy
import pytest

from test_slicer import FOLDER, ORIGIN, SPACING, inputs, lib  # noqa: F401


class Widget:
    """Takes what Qt takes; attributes are what was set."""

    def __init__(self, *arguments):
        self.rows, self.slots, self.node, self.items = [], {}, None, []

    def addRow(self, label, widget):
        self.rows.append(label)

    def addWidget(self, widget):
        pass

    addStretch = setMRMLScene = addWidget

    def addItems(self, words):
        self.items, self.currentText = words, words[0]

    def connect(self, signal, slot):
        self.slots[signal] = slot

    def setCurrentNode(self, node):
        self.node = node

    def currentNode(self):
        return self.node


class PathEdit(Widget):
    Dirs = 1
    currentPath = ""


class Node:
    def __init__(self, name, file=None, points=None, kind="vtkMRMLMarkupsCurveNode"):
        self.name, self.file, self.points, self.kind, self.locked = name, file, points, kind, False

    def GetName(self):
        return self.name

    def SetName(self, name):
        self.name = name

    def GetID(self):
        return self.name

    def GetClassName(self):
        return self.kind

    def SetCurveTypeToLinear(self):
        pass

    def SetLocked(self, locked):
        self.locked = locked


class Scene:
    """What slicer.util and the scene do, with files for nodes."""

    def __init__(self):
        self.curves, self.models, self.markups, self.drawn, self.cursors = [], [], [], [], []

    def AddNewNodeByClass(self, kind, name):
        self.drawn.append(Node(name, kind=kind))
        return self.drawn[-1]

    def saveNode(self, node, file):
        return bool(node.file) and bool(shutil.copy(node.file, file))

    def getNodesByClass(self, kind):
        return [node for node in self.curves if node.kind == kind]

    def arrayFromMarkupsControlPoints(self, node, world):
        assert world
        return node.points

    def updateMarkupsControlPointsFromArray(self, node, points):
        node.points = numpy.asarray(points)

    def load(self, into):
        def take(file):
            into.append(Node("", pathlib.Path(file).read_bytes()))
            return into[-1]

        return take


@pytest.fixture
def form(program_of_slicer, monkeypatch, lib):  # noqa: F811
    scene = Scene()
    qt = types.ModuleType("qt")
    for name in ("QFormLayout", "QLabel", "QDoubleSpinBox", "QHBoxLayout", "QComboBox", "QPushButton"):
        setattr(qt, name, Widget)
    qt.Qt = types.SimpleNamespace(WaitCursor=1)
    ctk = types.ModuleType("ctk")
    ctk.ctkCollapsibleButton, ctk.ctkPathLineEdit = Widget, PathEdit
    slicer = types.ModuleType("slicer")
    slicer.qMRMLNodeComboBox, slicer.mrmlScene = Widget, scene
    slicer.app = types.SimpleNamespace(
        setOverrideCursor=scene.cursors.append, restoreOverrideCursor=lambda: scene.cursors.pop()
    )
    slicer.util = types.SimpleNamespace(
        saveNode=scene.saveNode, getNodesByClass=scene.getNodesByClass,
        arrayFromMarkupsControlPoints=scene.arrayFromMarkupsControlPoints,
        updateMarkupsControlPointsFromArray=scene.updateMarkupsControlPointsFromArray,
        loadModel=scene.load(scene.models), loadMarkups=scene.load(scene.markups),
    )
    loadable = types.ModuleType("slicer.ScriptedLoadableModule")
    for end in ("", "Logic", "Test", "Widget"):
        setattr(loadable, "ScriptedLoadableModule" + end, type("ScriptedLoadableModule" + end, (), {"layout": Widget(), "setup": lambda self: None}))
    for module in (qt, ctk, slicer, loadable, types.ModuleType("vtk")):
        monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.setenv("DENTALSCR_PROGRAM", str(program_of_slicer))
    spec = importlib.util.spec_from_file_location("DentalSCR", FOLDER / "DentalSCR.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    widget = module.DentalSCRWidget()
    widget.setup()
    return types.SimpleNamespace(widget=widget, scene=scene)


def press(form):
    form.widget.button.slots["clicked()"]()
    assert not form.scene.cursors
    return form.widget.answer.text


def test_filled_in_and_pressed_it_loads_the_result(form, inputs, lib, run, sample, tmp_path):  # noqa: F811
    widget, scene = form.widget, form.scene
    widget.upper.node, widget.lower.node = Node("upper", inputs.upper), Node("lower", inputs.lower)
    widget.image.node = Node("radiograph", inputs.image)
    widget.scanLandmarks.node = Node("scan landmarks", inputs.scanLandmarks)
    for box, value in zip(widget.spacing, map(float, inputs.spacing.split(","))):
        box.value = value
    widget.facing.currentText = inputs.case["cephalogram"]["facing"]
    widget.folder.currentPath = str(tmp_path / "result")
    # Curves as they were drawn: Slicer's coordinates are RAS.
    grid = lib.ImageGrid.read(str(inputs.image))
    for jaw, outlines in json.loads(inputs.contours.read_text())["contours"].items():
        for outline in outlines:
            kind = "vtkMRMLMarkupsClosedCurveNode" if outline.get("closed") else "vtkMRMLMarkupsCurveNode"
            scene.curves.append(Node(outline["code"] or jaw, points=grid.from_pixels(outline["points"]) * [-1.0, -1.0, 1.0], kind=kind))
    scene.curves.append(Node("F", points=numpy.zeros((2, 3))))
    widget.enter()
    assert "F" not in widget.curves.text.split(", ") and len(widget.curves.text.split(", ")) == len(scene.curves) - 1
    answer = press(form)
    result = json.loads((tmp_path / "result" / "result.json").read_text())
    for jaw in ("upper", "lower"):
        assert f"{jaw}: {result['jaws'][jaw]['status']}" in answer
    assert widget.page.enabled and (tmp_path / "result" / "report.html").exists()
    # The same drawing by the shell is the same answer, to what a VTP's digits and the ear rods' place leave.
    assert run("register", sample / "case.json", "--output", tmp_path / "shell", "--no-page").returncode == 0
    shell = json.loads((tmp_path / "shell" / "result.json").read_text())
    for jaw, entry in shell["jaws"].items():
        for name, place in entry["landmarks_px"].items():
            numpy.testing.assert_allclose(result["jaws"][jaw]["landmarks_px"][name], place, atol=2.0)
    # What is loaded is what was written: moved scans, markups, and outlines on the radiograph, RAS.
    assert [node.name for node in scene.models] == [f"{jaw} scan, {result['jaws'][jaw]['status']}" for jaw in ("upper", "lower")]
    assert all(b"SPACE=LPS" in node.file[:80] for node in scene.models)
    assert [node.name for node in scene.markups] == ["Predicted landmarks"]
    page = json.loads((tmp_path / "result" / "report.json").read_text())
    outlines = lib.outlines_of(result, page)
    assert len(scene.drawn) == len(outlines) > 0
    for node, (name, closed, pixels) in zip(scene.drawn, outlines):
        assert node.name == name and node.locked and ("Closed" in node.kind) == closed
        numpy.testing.assert_allclose(
            node.points[:, :2], (numpy.asarray(pixels) * SPACING + ORIGIN[:2]) * [-1.0, -1.0], atol=1e-6
        )


def test_what_is_missing_is_said_on_the_form(form, inputs):  # noqa: F811
    assert "no radiograph was chosen" in press(form)
    form.widget.image.node = Node("radiograph", inputs.image)
    assert "could not be registered" in press(form)
    form.widget.upper.node = Node("gone")
    assert "gone could not be written" in press(form)
    assert not form.widget.page.enabled
