"""Doxygen's input filter for our headers: doxygen_filter.py FILE, to standard output; Utilities/doxygen.sh runs it.

The headers are written as ITK's are, where a comment is about all declarations up to the next empty line or comment: a setter
and its getter, an alias beside another. Doxygen takes it for the first one's alone, and so a comment before several becomes one
of a group. What every ITK class has, its names for itself and the methods that the pipeline calls, needs no comment in each
header, and gets its words here.
"""
import pathlib
import re
import sys

# Of a declaration without a comment: what it matches, and what is said of it.
COMMON = (
    (r"using Self = ", "This class."),
    (r"using Superclass = ", "The class that this one is derived from."),
    (r"using Pointer = ", "Smart pointer to an object of this class."),
    (r"using ConstPointer = ", "Smart pointer to an object of this class that can't be changed through it."),
    (r"itkTypeMacro\(", "Name of the class, as PrintSelf() and errors show it."),
    (r"itk(Simple|Factoryless)?NewMacro\(", "Makes an object, by the object factory where one overrides the class."),
    (r"itkCloneMacro\(", "Copy of the object with its settings."),
    (r".*\bPrintSelf\(.*\boverride\b", "Writes the settings of the object, one a line."),
    (r".*\bGenerateData\(.*\boverride\b", "Computes the outputs; Update() calls it."),
    (r".*\bGenerateOutputInformation\(.*\boverride\b", "Says what the outputs will be, before they are computed."),
    (r".*\bGenerateInputRequestedRegion\(.*\boverride\b", "Asks for as much of the inputs as is needed: all of them."),
    (r".*\bEnlargeOutputRequestedRegion\(.*\boverride\b", "Outputs are computed as wholes."),
    (r".*\bVerifyPreconditions\(.*\boverride\b", "Throws where an input or a setting is missing or wrong, before anything is computed."),
    (r".*\bVerifyInputInformation\(.*\boverride\b", "Inputs need not lie in one space: a mesh is in mm and a radiograph in pixels."),
    (r".*\bMakeOutput\(.*\boverride\b", "Makes an output of the type that its place in the list has; ProcessObject calls it."),
    (r".*\bGraft\(.*\boverride\b", "Takes over what another object of this type holds."),
    (r".*\bInternalClone\(.*\boverride\b", "Copy of the object; Clone() calls it."),
    (r".*\bGetMTime\(.*\boverride\b", "Time of the last change of the object, and of what it holds."),
    (r".*= delete;", "Not for use: the object is not copied."),
    (r"~\w+\(\)|virtual ~\w+\(\)", "Destroys the object; with objects of ITK the last smart pointer does."),
)


def declarations(lines, start):
    """From the line after a comment: (first line, one past the last) of each declaration up to an empty line or a comment."""
    found, at = [], start
    while at < len(lines):
        text = lines[at].strip()
        if not text or text.startswith(("/*", "//", "public", "protected", "private", "}", "#")):
            break
        first, depth, ended = at, 0, False
        while at < len(lines) and not ended:
            bare = re.sub(r'"(\\.|[^"\\])*"|//.*|/\*.*?\*/', "", lines[at])
            depth += sum(map(bare.count, "({")) - sum(map(bare.count, ")}"))
            # An enumerator, which ends with a comma or the brace of the whole, is no declaration of its own.
            if depth < 0 or depth == 0 and (bare.strip().startswith("/*") or bare.rstrip().endswith(",") and at == first):
                return found
            at += 1
            # A declaration ends with a semicolon, or with the brace of its body.
            ended = depth == 0 and re.search(r"[;}]\s*$|^\s*itk\w+Macro\(.*\)\s*$", bare) is not None
        # That an object can't be copied is said in a word, and by no comment.
        if not ended or re.search(r"= delete;$", lines[at - 1]):
            return found
        found.append((first, at))
    return found


def common_words(declaration):
    """What is said of a declaration that every class of ITK has; None of any other."""
    text = ""
    for line in declaration:
        text += " " * bool(text) + line.strip()
        if re.search(r"[;{}]$|^itk\w+Macro\(.*\)$", text):
            break
    return next((words for pattern, words in COMMON if re.match(pattern, text)), None)


def filtered(lines):
    """The lines, as many as before: comments about several declarations are those of groups, and ITK's idioms have words."""
    marks = [""] * len(lines)
    at = 0
    while at < len(lines):
        if re.match(r"\s*/\*\*(?!/|<)", lines[at]):
            first = at
            while "*/" not in lines[at]:
                at += 1
            at += 1
            # What begins a block is one thing, and a comment that names its subject is about that.
            named = re.search(r"[\\@](class|struct|enum|file|mainpage|defgroup|namespace|fn|var|name)\b|[\\@][{}]", "\n".join(lines[first:at]))
            about = declarations(lines, at)
            opens = about and re.match(r"\s*(template|class|struct|union|enum|namespace|extern)\b", lines[about[0][0]])
            if about and (named or opens):
                about = about[:1]
                if re.search(r"\{\s*$", lines[at]) or lines[at + 1 : at + 2] and lines[at + 1].strip() == "{" or named:
                    continue  # into the block
            if len(about) > 1 and not lines[about[-1][1]].startswith("#"):
                marks[first] += "/**@{*/ "
                marks[about[-1][1]] += "/**@}*/ "
            if about:
                at = about[-1][1]
        else:
            starts = at == 0 or re.search(r"(^\s*|[;{}:)]|\*/)$", lines[at - 1])
            words = common_words(lines[at : at + 3]) if starts else None
            if words:
                marks[at] += f"/** {words} */ "
            at += 1
    return [mark + line for mark, line in zip(marks, lines)]


if __name__ == "__main__":
    print("\n".join(filtered(pathlib.Path(sys.argv[1]).read_text().split("\n"))), end="")
