"""Sphinx's configuration of the site. Utilities/site.sh runs it on the pages that Utilities/site_pages.py has laid out."""
import pathlib
import re
import xml.etree.ElementTree

from docutils import nodes
from sphinx.transforms.post_transforms import SphinxPostTransform

ROOT = pathlib.Path(__file__).resolve().parent.parent

project = "DentalSCR"
author = "The DentalSCR authors"
copyright = "The DentalSCR authors, Apache-2.0"
release = version = re.search(r"^\s+VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text(), re.M).group(1)

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
root_doc = "index"
highlight_language = "none"
myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence", "deflist"]

autosummary_generate = True
autosummary_imported_members = True
# The signature of a compiled method is the first line of its docstring.
autodoc_docstring_signature = True
autodoc_member_order = "bysource"
autodoc_typehints = "none"
napoleon_google_docstring = False
python_maximum_signature_line_length = 100

templates_path = ["_templates"]
html_theme = "furo"
html_title = f"DentalSCR {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
# Nothing is asked of the network: a site on a disk, or behind a clinic's wall, looks and searches the same.
html_theme_options = {
    "source_repository": "",
    "navigation_with_keys": True,
    "footer_icons": [],
}


def doxygen_classes():
    """Page of each C++ class and function by its name, from the tag file that doxygen leaves."""
    tags = ROOT / "build" / "doxygen" / "dentalscr.tag"
    if not tags.is_file():
        return {}
    pages = {}
    for compound in xml.etree.ElementTree.parse(tags).getroot():
        if compound.get("kind") in ("class", "struct"):
            name = compound.findtext("name").split("<")[0].strip()
            pages[name.rsplit("::", 1)[-1]] = compound.findtext("filename")
        elif compound.get("kind") == "namespace":
            for member in compound.iter("member"):
                if member.get("kind") == "function":
                    pages.setdefault(
                        member.findtext("name"), member.findtext("anchorfile") + "#" + member.findtext("anchor")
                    )
    return pages


class LinkClasses(SphinxPostTransform):
    """A class that a page names in passing becomes a link to its page of the C++ reference."""

    default_priority = 900

    def run(self, **keywords):
        docname = self.env.docname
        if docname.startswith(("python/", "CommandLine")):
            return
        classes = self.app.doxygen_classes
        up = "../" * docname.count("/")
        for literal in list(self.document.findall(nodes.literal)):
            parent = literal.parent
            while parent is not None and not isinstance(parent, (nodes.reference, nodes.title)):
                parent = parent.parent
            match = re.fullmatch(r"(?:itk::)?(\w+)(?:\(\))?", literal.astext())
            if parent is None and match and match.group(1) in classes:
                link = nodes.reference("", "", refuri=f"{up}cpp/{classes[match.group(1)]}", internal=True)
                literal.replace_self(link)
                link += literal


def setup(app):
    app.doxygen_classes = doxygen_classes()
    app.add_post_transform(LinkClasses)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
