"""What the program takes before a verb's own work begins."""
import os
import re
import subprocess

import pytest


def mapped(program):
    """The shared libraries that the loader maps when the program starts."""
    done = subprocess.run(["ldd", str(program)], capture_output=True, text=True)
    return {line.split()[0].rsplit("/")[-1].split(".so")[0] for line in done.stdout.splitlines() if line.strip()}


@pytest.fixture(scope="module")
def libraries(program, is_sanitized):
    if is_sanitized:
        pytest.skip("a sanitizer is linked first, and so that all libraries are loaded, needed or not")
    found = mapped(program)
    if "libDentalSCRCommandLine" not in found:
        pytest.skip("libraries of ours are inside the program")
    return found


# What one or two verbs need, and what comes with it: each is loaded by these verbs.
LOADED_WHERE_NEEDED = {
    "the phantom and the studies": ["libDentalSCRDentalPhantom", "libDentalSCRExperiment", "libDentalSCRBaselines"],
    "image formats that render writes": ["libITKIOMeta", "libITKMetaIO", "libITKIONRRD", "libITKIOTIFF", "libITKIOBMP"],
    "TIFF radiographs": ["libtiff", "libitktiff", "libLerc", "libwebp", "libjbig", "libzstd", "liblzma"],
    "meshes that are written": ["libOpenMesh"],
    "overlays": ["libcairo", "libX11", "libxcb", "libpixman", "libfontconfig", "libfreetype"],
    "DICOM": ["libgdcm", "libITKIOGDCM"],
    "transforms that are written": ["libITKTransformFactory", "libITKIOTransform"],
    "the tracing page": ["libcpp-httplib", "libssl", "libcrypto"],
}


@pytest.mark.parametrize("what", LOADED_WHERE_NEEDED)
def test_what_few_verbs_need_is_not_mapped_by_all(libraries, what):
    prefixes = tuple(LOADED_WHERE_NEEDED[what])
    assert [name for name in libraries if name.startswith(prefixes)] == []


def test_itk_is_asked_first_for_a_symbol(program, libraries):
    """Most symbols that our libraries look up are ITKCommon's, and the loader asks in this order."""
    done = subprocess.run(["readelf", "-dW", str(program)], capture_output=True, text=True, check=True)
    needed = re.findall(r"\(NEEDED\).*\[(.*?)\]", done.stdout)
    assert needed[0].startswith("libITKCommon"), needed


def test_symbols_that_are_looked_up_stay_few(program, libraries):
    """Their number is what the start of the program costs. The bound is a tenth above what was counted on Debian 12."""
    done = subprocess.run(
        [str(program), "--version"], env={**os.environ, "LD_DEBUG": "statistics"}, capture_output=True, text=True, check=True
    )
    final = re.search(r"final number of relocations: (\d+)", done.stderr)
    if final is None:
        pytest.skip("this loader has no statistics")
    assert int(final.group(1)) < 15000, done.stderr
