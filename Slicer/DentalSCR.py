"""A scripted module of 3D Slicer: a form around the module DentalSCR Register that takes curves as they were drawn, and shows the
result: the scans where the radiograph was taken of them, the predicted landmarks and the aligned outlines on the radiograph.

What needs no Slicer is in DentalSCRLib, and is tested without it.
"""
import json
import os
import pathlib
import sys
import tempfile

import ctk
import numpy
import qt
import slicer
import vtk
from slicer.ScriptedLoadableModule import (
    ScriptedLoadableModule,
    ScriptedLoadableModuleLogic,
    ScriptedLoadableModuleTest,
    ScriptedLoadableModuleWidget,
)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import DentalSCRLib as lib  # noqa: E402


class DentalSCR(ScriptedLoadableModule):
    def __init__(self, parent):
        super().__init__(parent)
        self.parent.title = "DentalSCR"
        self.parent.categories = ["Dental"]
        self.parent.contributors = ["The DentalSCR authors"]
        self.parent.helpText = (
            "Aligns scans of the teeth with a lateral cephalometric radiograph. Draw the border of each crown as an open curve "
            "that is named after its tooth (UR1), or mark landmarks of an analysis (U1_tip), and press Register. "
            "Research software, not a medical device."
        )
        self.parent.acknowledgementText = ""


class DentalSCRWidget(ScriptedLoadableModuleWidget):
    def setup(self):
        super().setup()
        self.logic = DentalSCRLogic()
        box = ctk.ctkCollapsibleButton()
        box.text = "Case"
        self.layout.addWidget(box)
        form = qt.QFormLayout(box)
        self.upper = self.addSelector(form, "Upper scan", ["vtkMRMLModelNode"])
        self.lower = self.addSelector(form, "Lower scan", ["vtkMRMLModelNode"])
        self.image = self.addSelector(form, "Radiograph", ["vtkMRMLScalarVolumeNode", "vtkMRMLVectorVolumeNode"])
        self.landmarks = self.addSelector(form, "Landmarks on the radiograph", ["vtkMRMLMarkupsFiducialNode"])
        self.scanLandmarks = self.addSelector(form, "Landmarks on the scans", ["vtkMRMLMarkupsFiducialNode"])
        self.curves = qt.QLabel()
        form.addRow("Curves", self.curves)

        self.spacing = [qt.QDoubleSpinBox() for _ in range(2)]
        row = qt.QHBoxLayout()
        for box, tip in zip(self.spacing, ("u", "v")):
            box.decimals, box.minimum, box.maximum, box.singleStep, box.value = 4, 0.0, 5.0, 0.01, 0.0
            box.toolTip = f"mm a pixel along {tip} in the plane of the detector; 0 where it is not known"
            row.addWidget(box)
        form.addRow("Pixel spacing, mm", row)
        self.facing = qt.QComboBox()
        self.facing.addItems(["right", "left"])
        form.addRow("The face looks to the", self.facing)
        self.folder = ctk.ctkPathLineEdit()
        self.folder.filters = ctk.ctkPathLineEdit.Dirs
        form.addRow("Folder for the result", self.folder)

        self.button = qt.QPushButton("Register")
        self.button.connect("clicked()", self.onRegister)
        self.layout.addWidget(self.button)
        self.answer = qt.QLabel()
        self.answer.wordWrap = True
        self.layout.addWidget(self.answer)
        self.page = qt.QPushButton("Open the report")
        self.page.enabled = False
        self.page.connect("clicked()", self.onOpen)
        self.layout.addWidget(self.page)
        self.layout.addStretch(1)
        self.enter()

    def addSelector(self, form, label, kinds):
        selector = slicer.qMRMLNodeComboBox()
        selector.nodeTypes = kinds
        selector.noneEnabled = True
        selector.addEnabled = False
        selector.removeEnabled = False
        selector.setMRMLScene(slicer.mrmlScene)
        selector.setCurrentNode(None)
        form.addRow(label, selector)
        return selector

    def enter(self):
        names = [node.GetName() for node in self.logic.curveNodes()]
        self.curves.text = ", ".join(names) if names else "none that is named after a tooth or a jaw"

    def onRegister(self):
        self.enter()
        self.answer.text = "…"
        slicer.app.setOverrideCursor(qt.Qt.WaitCursor)
        try:
            result = self.logic.register(
                self.upper.currentNode(),
                self.lower.currentNode(),
                self.image.currentNode(),
                self.logic.curveNodes(),
                self.landmarks.currentNode(),
                self.scanLandmarks.currentNode(),
                [box.value for box in self.spacing],
                self.facing.currentText,
                self.folder.currentPath,
            )
            self.answer.text = lib.describe(result)
            self.page.enabled = bool(self.folder.currentPath)
        except (lib.ProgramError, OSError, ValueError) as error:
            self.answer.text = str(error)
        finally:
            slicer.app.restoreOverrideCursor()

    def onOpen(self):
        qt.QDesktopServices.openUrl(qt.QUrl.fromLocalFile(os.path.join(self.folder.currentPath, "report.html")))


class DentalSCRLogic(ScriptedLoadableModuleLogic):
    def curveNodes(self):
        """Curves and lines of the scene that are named after a tooth or a jaw."""
        kinds = ("vtkMRMLMarkupsCurveNode", "vtkMRMLMarkupsClosedCurveNode", "vtkMRMLMarkupsLineNode")
        nodes = {node.GetID(): node for kind in kinds for node in slicer.util.getNodesByClass(kind)}
        return [node for node in nodes.values() if lib.is_code(node.GetName())]

    def register(self, upper, lower, image, curves, landmarks, scanLandmarks, spacing, facing, output):
        """Writes the nodes as Slicer's own modules get them, runs the program, and loads what came out."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            words = {"facing": facing, "image": self.save(image, folder / "image.nrrd")}
            words["upper"] = self.save(upper, folder / "upper.vtp")
            words["lower"] = self.save(lower, folder / "lower.vtp")
            words["landmarks"] = self.save(landmarks, folder / "landmarks.mrk.json")
            words["scanLandmarks"] = self.save(scanLandmarks, folder / "scan.mrk.json")
            if not words["image"]:
                raise lib.ProgramError("no radiograph was chosen")
            grid = lib.ImageGrid.read(words["image"])
            if curves:
                drawn = [(node.GetName(), "ClosedCurve" in node.GetClassName(), self.pointsOf(node)) for node in curves]
                file = folder / "contours.json"
                file.write_text(json.dumps(lib.contours_from_curves(drawn, grid)))
                words["contours"] = str(file)
            if all(value > 0 for value in spacing):
                words["spacing"] = ",".join(map(repr, spacing))
            target = pathlib.Path(output) if output else folder / "result"
            moved = {jaw: folder / f"{jaw}_moved.stl" for jaw in ("upper", "lower") if words[jaw]}
            words.update({f"{jaw}Moved": str(file) for jaw, file in moved.items()})
            words.update(output=str(target), predicted=str(folder / "predicted.mrk.json"))
            from DentalSCRLib import modules

            code = modules.main("register", [word for key, value in words.items() if value for word in (f"--{key}", value)])
            if code != 0:
                raise lib.ProgramError("the case could not be registered; the reason is in Slicer's log and Python console")
            result = lib.read_result(target)
            page = json.loads((target / "report.json").read_text(encoding="utf-8"))
            self.load(result, page, moved, folder / "predicted.mrk.json", grid)
            return result

    @staticmethod
    def save(node, file):
        if node is None:
            return ""
        if not slicer.util.saveNode(node, str(file)):
            raise lib.ProgramError(f"{node.GetName()} could not be written to {file}")
        return str(file)

    @staticmethod
    def pointsOf(node):
        """Control points in LPS, mm: Slicer's own coordinates are RAS."""
        points = numpy.array(slicer.util.arrayFromMarkupsControlPoints(node, world=True), dtype=float)
        return points * [-1.0, -1.0, 1.0]

    @staticmethod
    def load(result, page, moved, predicted, grid):
        for jaw, file in moved.items():
            if file.exists():
                slicer.util.loadModel(str(file)).SetName(f"{jaw} scan, {result['jaws'][jaw]['status']}")
        if predicted.exists():
            slicer.util.loadMarkups(str(predicted)).SetName("Predicted landmarks")
        for name, closed, pixels in lib.outlines_of(result, page):
            kind = "vtkMRMLMarkupsClosedCurveNode" if closed else "vtkMRMLMarkupsCurveNode"
            node = slicer.mrmlScene.AddNewNodeByClass(kind, name)
            node.SetCurveTypeToLinear()
            slicer.util.updateMarkupsControlPointsFromArray(node, grid.from_pixels(pixels) * [-1.0, -1.0, 1.0])
            node.SetLocked(True)


class DentalSCRTest(ScriptedLoadableModuleTest):
    """Runs in Slicer: the frames only. What the program gives is tested in the project, without Slicer."""

    def runTest(self):
        matrix = vtk.vtkMatrix4x4()
        for row in range(4):
            for column in range(4):
                matrix.SetElement(row, column, lib.LPS_FROM_CEPHALOSTAT[row, column])
        self.assertAlmostEqual(matrix.Determinant(), 1.0)
