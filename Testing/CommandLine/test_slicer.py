"""The program as a module of 3D Slicer: --xml, and the call that Slicer makes of it."""
import xml.etree.ElementTree as ElementTree


def test_xml_describes_every_parameter_as_the_execution_model_wants(run):
    done = run("--xml")
    assert done.returncode == 0 and done.stderr == ""
    root = ElementTree.fromstring(done.stdout)
    assert root.tag == "executable"
    for name in ("category", "title", "description", "version", "parameters"):
        assert root.find(name) is not None, name
    assert root.find("version").text in run("--version").stdout
    for item in root.iterfind("parameters/*"):
        if item.tag not in ("label", "description"):
            for child in ("name", "label", "description"):
                assert item.find(child) is not None, (item.tag, child)
            returned = item.find("channel") is not None and item.find("channel").text == "output" and item.tag == "string"
            assert (item.find("index") is not None or item.find("longflag") is not None) != returned, item.find("name").text


def test_the_call_that_slicer_makes_registers_and_returns_the_status(run, sample, tmp_path):
    root = ElementTree.fromstring(run("--xml").stdout)
    items = [item for item in root.iterfind("parameters/*") if item.find("name") is not None]
    values = {"caseFile": sample / "case.json", "output": tmp_path / "result"}
    call = []
    for item in items:
        value = values.get(item.find("name").text, item.findtext("default"))
        if item.find("longflag") is not None:
            call += [item.find("longflag").text, value]
    indexed = sorted((int(item.find("index").text), item) for item in items if item.find("index") is not None)
    positional = [values.get(item.find("name").text, item.findtext("default")) for _, item in indexed]
    # Slicer puts the flags before the arguments by position.
    done = run("--returnparameterfile", tmp_path / "returned", *call, *positional)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "returned").read_text() in ("status = ok\n", "status = suspect\n")
    assert (tmp_path / "result" / "result.json").exists()
