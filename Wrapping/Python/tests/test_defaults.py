"""What nobody has set is in Python what it is in C++: of filters, metrics and optimizers, and of the functions beside them."""
import inspect
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[3]

#: Say what happened, and are what has not happened yet in other words.
OTHER_WORDS = {"TracedSideFilter.Reason"}


def meaning(text):
    """The value of a member's initializer, where it is a number, a switch or the value of an enumeration."""
    if text in ("true", "false"):
        return text == "true"
    number = re.fullmatch(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[fFuU]?", text)
    if number:
        return float(number[1])
    word = re.fullmatch(r"(?:\w+::)*\w+Enum(?:s::\w+)?::(\w+)", text)
    return word[1] if word else None


def members(header):
    """Members of a class that a header declares with their values: m_Sigma{ 0.5 }."""
    for name, text in re.findall(r"^\s+[\w:<>, ]+?\s+m_(\w+)\{ ?([^{}]*?) ?\};", header.read_text(), re.M):
        value = meaning(text)
        if value is not None:
            yield name, value


def same(value, stated):
    return value.name == stated if isinstance(stated, str) and hasattr(value, "name") else value == stated


def test_what_is_not_set_is_what_the_headers_say(ds):
    compared = []
    for header in sorted((ROOT / "Modules").glob("*/*/include/itk*.h")):
        name = header.stem[3:]
        for kind in (getattr(ds, word, None) or getattr(ds._core, word, None) for word in (name, name + "2D", name + "3D")):
            if not inspect.isclass(kind):
                continue
            try:
                made = kind()
            except TypeError:
                # Abstract, or nothing that is made empty.
                continue
            for member, stated in members(header):
                get = getattr(made, "Get" + member, None)
                if get is None or f"{name}.{member}" in OTHER_WORDS:
                    continue
                assert same(get(), stated), f"{name}.Get{member}() is {get()!r}; {header.name} says {stated!r}"
                compared.append(f"{name}.{member}")
    assert len(compared) > 150


def test_functions_take_what_their_classes_take(ds):
    compared = []
    for name, function in inspect.getmembers(ds, inspect.isfunction):
        kinds = (getattr(ds, name + end, None) for end in ("ImageSource", "Source", "Filter", "Method"))
        kind = next((each for each in kinds if each is not None), None)
        if kind is None:
            continue
        made = kind()
        for parameter in inspect.signature(function).parameters.values():
            get = getattr(made, "Get" + parameter.name[0].upper() + parameter.name[1:], None)
            if get is None or parameter.default in (None, inspect.Parameter.empty):
                continue
            assert same(get(), parameter.default), f"{name}({parameter.name}={parameter.default!r}), the class has {get()!r}"
            compared.append(parameter.name)
    assert len(compared) > 20


def test_level_of_the_papers_registration_begins_as_in_cxx(ds):
    header = (ROOT / "Modules/Registration/SilhouetteToContour/include/itkSilhouetteToContourLevel.h").read_text()
    stated = dict(re.findall(r"^  (?:double|unsigned int|std::size_t) (\w+)\{ ?([^}]*?) ?\};", header, re.M))
    assert len(stated) == 8
    for name, text in stated.items():
        assert getattr(ds.RegistrationLevel(), name) == meaning(text), name


def test_metric_by_its_short_name_is_the_metric_that_nobody_has_set(ds):
    """SetMetricAsChamfer() without arguments, ContourChamferMetricv4() and the method without either."""
    said = dict(re.findall(r"(\w+): [\w. |]+ = ([^,)]+\)?)", ds.SilhouetteToContourRegistrationMethod.SetMetricAsChamfer.__doc__))
    metric = ds.ContourChamferMetricv4()
    assert said["direction"] == str(metric.GetDirection())
    assert said["distance"] == str(metric.GetDistance())
    assert float(said["truncation"].split("'")[1]) == metric.GetTruncation()
