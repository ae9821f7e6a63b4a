"""Libraries print nothing: what they have to say is an exception, an event, a warning among the results, or goes to a stream that
the caller gave. Only the program writes to the standard streams, and ITK's output window, which a user may replace, gets the one
thing that no caller can be told."""
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = sorted(
    path
    for folder in ("include", "src")
    for path in (ROOT / "Modules").glob(f"*/*/{folder}/*")
    if path.suffix in (".h", ".hxx", ".cxx") and "CommandLine" not in path.parts
)
# Threads that cannot be started: the work goes on with fewer, in a function without a result of its own.
TOLD_THROUGH_THE_WINDOW = {"itkParallelFor.cxx"}

STREAMS = re.compile(
    r"\bstd::w?(?:cout|cerr|clog)\b|#\s*include\s*<(?:iostream|print)>"
    r"|\b(?:v?f?w?printf|f?puts|putchar|perror|psignal)\s*\(|\b(?:stdout|stderr)\b"
    # Where a child process writes is another matter: a library gives it a pipe in their place.
    r"|\bd?write\s*\(\s*(?:STD(?:OUT|ERR)_FILENO|[12])\s*,"
)
WINDOW = re.compile(r"\bOutputWindow\w*\b|\b(?:itk|vtk)(?:Generic)?(?:Warning|Debug|Output|Error)(?:WithObject)?(?:StringMacro|Macro)\b")


def code_of(text):
    """A source without its comments; what a string says stays where no comment's beginning is in it."""
    return re.sub(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', lambda match: match[1] or "", text, flags=re.S)


def test_there_are_sources():
    assert len(SOURCES) > 500


@pytest.mark.parametrize("pattern", [STREAMS, WINDOW], ids=["the standard streams", "the output window"])
def test_no_library_writes_to(pattern):
    found = {}
    for path in SOURCES:
        if pattern is WINDOW and path.name in TOLD_THROUGH_THE_WINDOW:
            continue
        words = [match[0] for match in pattern.finditer(code_of(path.read_text()))]
        if words:
            found[str(path.relative_to(ROOT))] = words
    assert not found, f"throw, warn in the result, or write to a stream of the caller's: {found}"


@pytest.mark.parametrize(
    "line",
    [
        "#include <iostream>",
        'std::cerr << "text";',
        'std::printf("%d", 3);',
        'fprintf(stderr, "text");',
        'puts("text");',
        "write(STDERR_FILENO, text, 4);",
    ],
)
def test_a_line_that_prints_is_seen(line):
    assert STREAMS.search(code_of(line))


@pytest.mark.parametrize("line", ['itkWarningMacro(<< "text");', 'OutputWindowDisplayWarningText("text");'])
def test_a_line_that_warns_is_seen(line):
    assert WINDOW.search(code_of(line))


@pytest.mark.parametrize(
    "line",
    [
        "// observer->SetStream(&std::cout);",
        "/** as printf() writes it */",
        'std::snprintf(text, sizeof(text), "%g", 3.0);',
        '*m_Stream << "text";',
    ],
)
def test_a_line_that_does_not_print_is_none(line):
    assert not STREAMS.search(code_of(line))
