"""Lays out the pages of the site for Sphinx: site_pages.py FOLDER --program PATH --doxygen FOLDER.

The pages of Documentation/ become the top of the site, those of Examples/ a folder in it, and what the code says of itself is
written beside them: every verb's --help, and a page for each public name of the Python package, which must be importable.
"""
import argparse
import enum
import inspect
import pathlib
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent

# The parts of the Python reference in the order in which they are read: title, introduction, modules whose names it lists.
PARTS = (
    ("Cases and results", "A case file in, a registered case out; many cases at once.", ("_case", "_case_result", "_batch")),
    ("Pose registration", "What preset `robust` runs: the registration, its optimizer, terms and solution.",
     ("_pose", "_pose_metrics", "_pose_inputs", "_pose_downstream")),
    ("Registration of contours", "The paper's method and what it is compared with: similarities between two contours.",
     ("_registration", "_similarity")),
    ("Filters", "The steps before and after a registration.", ("_filters",)),
    ("Evaluation and pictures", "Landmark errors, overlays, experiments, the case in space.",
     ("_evaluation", "_pictures", "_scene")),
    ("Files", "Reading and writing.", ("_io",)),
    ("Other packages", "To and from numpy, SimpleITK, ITK's Python, VTK and trimesh.", ("_convert", "_inputs")),
    ("Phantom", "Cases with a known answer.", ("_phantom",)),
    ("Running and events", "What every process object has, and what it tells while it runs.", ("_process", "_events")),
    ("Errors", "What is raised.", ("_errors",)),
)


def rewrite(text, depth):
    """Links of the repository as links of the site, of a page that lies so many folders below its top."""

    def target(match):
        link = match.group(1)
        if "://" in link or link.startswith("#"):
            return match.group(0)
        path, _, anchor = link.partition("#")
        # Documentation/ is the top here, and what lies beside it in the repository lies in it.
        if path == "../" * max(depth, 1) + "README.md":
            path = "../" * depth + "Start.md"
        elif depth == 0:
            path = re.sub(r"^(\.\./|Documentation/)", "", path)
        else:
            path = path.replace("../Documentation/", "../")
        if path and (ROOT / "Examples" / pathlib.PurePath(path).name).is_dir():
            path += "/README.md"
        return f"]({path}{'#' + anchor if anchor and 'Start.md' not in path else ''})"

    parts = re.split(r"(^```.*?^```$)", text, flags=re.S | re.M)
    return "".join(part if part.startswith("```") else re.sub(r"\]\(([^)\s]+)\)", target, part) for part in parts)


def stage_pages(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in ("Images", "_static"):
        shutil.copytree(ROOT / "Documentation" / name, folder / name)
    shutil.copy(ROOT / "Documentation" / "conf.py", folder)
    pages = [(page, folder / page.name, 0) for page in (ROOT / "Documentation").glob("*.md")]
    pages += [(ROOT / name, folder / name, 0) for name in ("CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")]
    pages.append((ROOT / "Examples/README.md", folder / "Examples/README.md", 1))
    for example in (ROOT / "Examples").glob("*/README.md"):
        pages.append((example, folder / "Examples" / example.parent.name / "README.md", 2))
    for source in (ROOT / "Examples").glob("*/*"):
        if source.suffix in (".py", ".cxx", ".h", ".ipynb", ".txt"):
            copy = folder / "Examples" / source.parent.name / source.name
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
    for source, copy, depth in pages:
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(rewrite(source.read_text(), depth))
    with (folder / "Examples/README.md").open("a") as overview:
        overview.write("\n```{toctree}\n:hidden:\n:glob:\n\n*/README\n```\n")


def command_line_page(program):
    """Every verb with the text of its --help, as the program prints it."""

    def help_of(*verb):
        done = subprocess.run([program, *verb, "--help"], capture_output=True, text=True, check=True, timeout=60)
        return f"```text\n$ {' '.join(['dentalscr', *verb])} --help\n{done.stdout.rstrip()}\n```\n"

    top = help_of()
    verbs = re.findall(r"^  ([a-z]+) {2,}(\S.*)$", top.split("Subcommands:")[1].split("Example")[0], re.M)
    assert len(verbs) > 5, "the program lists its verbs"
    text = "# Command line\n\nThe program is called `dentalscr`, and its first word says what it does. This page is what the program prints of itself. "
    text += "What the files hold, and what the exit codes mean, is on the page [Files and units](FileFormats.md).\n\n" + top
    for verb, words in verbs:
        text += f"\n## `dentalscr {verb}`\n\n{words.rstrip('.')}.\n\n{help_of(verb)}"
    return text


def python_pages(folder):
    """The Python reference: a table for each part, and behind each name in it a page by autosummary."""
    import dentalscr

    homes = {}
    for file in pathlib.Path(dentalscr.__file__).parent.glob("_*.py"):
        if file.stem not in ("__init__", "__main__"):
            module = __import__(f"dentalscr.{file.stem}", fromlist=["_"])
            for name, value in vars(module).items():
                if getattr(value, "__module__", None) == module.__name__:
                    homes[name] = file.stem
    homes.update({"EventEnum": "_events"})
    public = sorted(name for name in dir(dentalscr) if not name.startswith("_"))
    public = [name for name in public if not inspect.ismodule(getattr(dentalscr, name))]
    values = {name: getattr(dentalscr, name) for name in public}
    constants = [name for name in public if not (inspect.isclass(values[name]) or callable(values[name]))]
    public = [name for name in public if name not in constants]
    enumerations = [
        name for name in public
        if inspect.isclass(values[name]) and (hasattr(values[name], "__members__") or issubclass(values[name], enum.Enum))
    ]
    text = (
        "# Python reference\n\n"
        "Every public name of the package `dentalscr`, by what it is for. The conventions (names, arrays, frames, events, threads) are on the page "
        "[Python](Python.md). Lengths are millimetres, places on the radiograph are continuous pixel indices (u to the right, v down, the centre of "
        "the first pixel is 0, 0), and angles are radians, where nothing else is said.\n"
    )
    left = [name for name in public if name not in enumerations]

    def part(title, words, names):
        names = sorted(names, key=str.lower)
        return (
            f"\n## {title}\n\n{words}\n\n```{{eval-rst}}\n.. currentmodule:: dentalscr\n\n.. autosummary::\n   :toctree: python\n\n"
            + "".join(f"   {name}\n" for name in names) + "```\n"
        )

    for title, words, modules in PARTS:
        names = [name for name in left if homes.get(name) in modules]
        assert names, title
        left = [name for name in left if name not in names]
        text += part(title, words, names)
    text += part("Data and parts of a registration", "Meshes, images, contours, transforms, metrics, kernels and hypotheses.", left)
    text += part("Enumerations", "A value may be given by its name too, in any case: `\"upper\"` for `Jaw.Upper`.", enumerations)
    (folder / "PythonAPI.md").write_text(text)
    templates = folder / "_templates" / "autosummary"
    templates.mkdir(parents=True)
    (templates / "class.rst").write_text(
        "{{ objname | escape | underline }}\n\n.. currentmodule:: {{ module }}\n\n.. autoclass:: {{ objname }}\n"
        "   :members:\n   :inherited-members: Exception, BaseException, int, float, str, tuple\n   :undoc-members:\n"
    )
    (templates / "base.rst").write_text(
        "{{ objname | escape | underline }}\n\n.. currentmodule:: {{ module }}\n\n.. auto{{ objtype }}:: {{ objname }}\n"
    )
    return len(public)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    stage_pages(arguments.folder)
    (arguments.folder / "CommandLine.md").write_text(command_line_page(arguments.program))
    names = python_pages(arguments.folder)
    print(f"{len(list(arguments.folder.rglob('*.md')))} pages, {names} names of the Python package")


if __name__ == "__main__":
    main()
