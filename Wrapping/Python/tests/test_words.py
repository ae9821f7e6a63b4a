"""Every public name of the package says what it is: help() of it has more than a signature."""
import inspect
import re


def words(value):
    """The docstring less what pybind11 writes by itself: signatures, and that there are several."""
    name = getattr(value, "__name__", "")
    lines = (getattr(value, "__doc__", None) or "").splitlines()
    own = [line for line in lines if not re.match(rf"\s*(\d+\. )?{re.escape(name)}\(.*\)( -> .*)?$", line)]
    return " ".join(line.strip() for line in own if line.strip() not in ("", "Overloaded function."))


def public_classes(package):
    """The classes that the package shows, and those of its own that they inherit methods from."""
    shown = {value for name, value in vars(package).items() if not name.startswith("_") and inspect.isclass(value)}
    return sorted(
        {base for value in shown for base in value.__mro__ if base.__module__.split(".")[0] == package.__name__},
        key=lambda value: (value.__module__, value.__name__),
    )


def members(package):
    """(name, docstring) of every public function, class, method and property; and of attributes that are values."""
    for name, value in sorted(vars(package).items()):
        if not name.startswith("_") and callable(value) and not inspect.isclass(value):
            yield name, words(value)
    for value in public_classes(package):
        yield value.__name__, words(value)
        for name, member in sorted(vars(value).items()):
            member = getattr(member, "__func__", member)
            if name.startswith("_") or inspect.isclass(member):
                continue
            if isinstance(member, property) or callable(member):
                yield f"{value.__name__}.{name}", words(member)


def test_everything_has_words(ds):
    found = dict(members(ds))
    assert len(found) > 1200
    silent = [name for name, text in found.items() if not text]
    assert not silent, f"{len(silent)} of {len(found)} have no words: {', '.join(silent)}"


def test_settings_say_what_is_set(ds):
    """A setter of a length, a width or an angle says its unit, or that of which it is a part."""
    units = re.compile(
        r"\b(mm|pixels?|px|rad|degrees?|triangles|points|positions|standard deviations?|parts?|share|metric|unit|vertices|radiograph|"
        r"picture|image|raster|frame|shown)\b"
    )
    lengths = re.compile(r"Set\w*(Spacing|Distance|Margin|Length|Width|Height|Range|Step|Gap|Sigma|Size)$")
    silent = [
        name for name, text in members(ds)
        if "." in name and lengths.match(name.split(".")[1]) and not units.search(text)
    ]
    assert not silent
