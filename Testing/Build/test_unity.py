"""A cold build reads a dozen sources of a library as one (CMAKE_UNITY_BUILD, preset demo): what two of them call by one name, each in
its anonymous namespace, would be two things of that name. Compiling them so finds it, and takes minutes; this finds it in a second."""
import collections
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARIES = [*sorted({path.parent for path in (ROOT / "Modules").glob("*/*/src/*.cxx")}), ROOT / "Wrapping/Python/src"]


def anonymous_parts(text):
    """Lines of the anonymous namespaces, in the house's format: namespace, brace, lines, '} // namespace'."""
    for match in re.finditer(r"^namespace\n\{\n(.*?)^\} // namespace\n", text, re.M | re.S):
        yield match[1]


def type_of(parameter):
    """A parameter without its name and its default."""
    parameter = re.sub(r"\s*=.*", "", " ".join(parameter.split()))
    return re.sub(r"(?<=[&*\s>])\w+(\[\])?$", "", parameter).replace(" ", "")


def names(text):
    """What a file's anonymous namespaces define at their outermost level: kind and name, a function's with its parameters."""
    for part in anonymous_parts(text):
        for kind, name in re.findall(r"^(class|struct|enum(?: class)?) (\w+)(?=[ :\n])", part, re.M):
            yield f"type {name}"
        for name in re.findall(r"^(?:constexpr|const|static)\b[^\n(;=]*?[ *](\w+)(?:\[[^\]]*\])*(?:\{| =|;)", part, re.M):
            yield f"variable {name}"
        for name, parameters in re.findall(r"^(\w+)\(([^()]*)\)(?: noexcept)?\n\{", part, re.M):
            depth, types, word = 0, [], ""
            for character in parameters + ",":
                depth += (character == "<") - (character == ">")
                if character == "," and depth == 0:
                    types.append(type_of(word))
                    word = ""
                else:
                    word += character
            yield f"function {name}({', '.join(types)})"


def aliases(text):
    """What a file calls by a name of its own at the outermost level of its namespaces: name and meaning. What another class calls
    by that name (PointType = Model::PointType) is left out: it may be the same thing, and here nothing tells."""
    found = re.findall(r"^using (\w+) = ([^;]+);", text, re.M)
    return [(name, meaning) for name, meaning in found if not meaning.endswith(f"::{name}")]


@pytest.mark.parametrize("folder", LIBRARIES, ids=lambda path: path.parent.name)
def test_no_two_files_of_a_library_define_one_name(folder):
    defined = collections.defaultdict(list)
    for path in sorted(folder.glob("*.cxx")):
        text = path.read_text()
        if re.search(r"^#(include <Eigen/|define [A-Z]+_INSTANTIATE)", text, re.M):
            # Compiled apart (DentalSCRBuildSettings.cmake).
            continue
        for name in set(names(text)):
            defined[name].append(path.name)
        for alias, meaning in aliases(text):
            # Twice the same is one.
            meant = defined[f"alias {alias}"]
            if not any(meaning == other for _, other in meant):
                meant.append((path.name, meaning))
    twice = {name: files for name, files in defined.items() if len(files) > 1}
    # A program of its own beside the library's sources.
    twice = {name: files for name, files in twice.items() if not {"dentalscrMain.cxx", "dentalscrView.cxx"} & set(files)}
    assert not twice, f"give each a name of its own, or one place to all of them: {twice}"


def test_a_name_that_is_defined_is_seen():
    text = """namespace
{
constexpr double Reach = 4.0;
const char * const Words[] = { "a" };
struct Part
{
  int reach;
};

double
Distance(const std::vector<double> & a, std::size_t count = 3)
{
  return 0.0;
}
} // namespace
"""
    assert set(names(text)) == {
        "variable Reach", "variable Words", "type Part", "function Distance(conststd::vector<double>&, std::size_t)",
    }


def test_an_alias_of_two_meanings_is_seen():
    text = "namespace\n{\nusing PointType = itk::Point<double, 2>;\nusing MeshType = Filter::MeshType;\n} // namespace\n"
    assert aliases(text) == [("PointType", "itk::Point<double, 2>")]


def test_bindings_are_looked_at_and_compiled_in_groups():
    """One by one they were two fifths of what `pip install .` compiles."""
    assert any(folder.parent.name == "Python" and (folder / "dentalscrModule.cxx").exists() for folder in LIBRARIES)
    text = (ROOT / "Wrapping/Python/CMakeLists.txt").read_text()
    assert "UNITY_BUILD OFF" not in text
    assert "set_target_properties(_core PROPERTIES UNITY_BUILD_BATCH_SIZE" in text


def test_no_binding_hides_what_a_header_gives_all():
    """What stands in an anonymous namespace is found before what is around it: where the files are one, by all of them."""
    folder = ROOT / "Wrapping/Python/src"
    given = {name for path in folder.glob("*.h") for name in re.findall(r"^(\w+)\(", path.read_text(), re.M)}
    assert {"ToFrame", "MakeArray"} <= given
    hidden = {
        f"{path.name}: {name}"
        for path in folder.glob("*.cxx")
        for part in anonymous_parts(path.read_text())
        for name in re.findall(r"^(\w+)\(", part, re.M)
        if name in given
    }
    assert not hidden
