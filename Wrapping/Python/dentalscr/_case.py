"""A case through the whole chain."""
from __future__ import annotations

import copy
import json
import os
from collections.abc import Mapping, Sequence
from typing import Any, Callable, Dict, Optional, Tuple, Union, cast

import numpy as np

from . import _core
from ._case_result import CaseResult
from ._errors import ArgumentError
from ._events import sitkProgressEvent
from ._inputs import (
    Array,
    ContourLike,
    ImageLike,
    LandmarksLike,
    MeshLike,
    PathLike,
    as_cephalometric_landmarks,
    as_contour,
    as_geometry,
    as_image,
    as_landmarks,
    as_mesh,
    as_path,
    is_path,
)
from ._process import ProcessObject


class Case:
    """One patient in memory: scans, tracing, radiograph, what is known of the geometry.

    Parameters
    ----------
    upper, lower : mesh-like, optional
        Scans in mm, each in any frame.
    upperContour, lowerContour : contour-like, optional
        The tracing of each jaw, continuous pixel indices.
    contours : path or Contours, optional
        Both tracings, instead.
    geometry : CephalometricGeometry or dict, optional
        Without it, and without a pixel spacing in it, the scale is estimated with a wide prior.
    image : image-like, optional
        The radiograph: for pictures.
    imageSize : (width, height), optional
        Of the radiograph, where there is no ``image``.
    principalPointKnown : bool, optional
        Whether the geometry's principal point is one. Default: whether it is not (0, 0).
    tracedSide : "right", "left", "mean", "both" or "standard", optional
        Default: "right", but "standard" where the landmarks or whole teeth are drawn as an analysis does.
    occlusion : "check", "true" or "false"
        Whether the scans share a frame in occlusion.
    cephalometricLandmarks : dict or path, optional
        Marked in the radiograph, to register with, alone or beside a tracing: ``{"U1_tip": (u, v)}``, or
        ``{"U1_tip": {"position": (u, v), "sigma_px": 2.0}}``, or a file (:func:`ReadCephalometricLandmarks`).
    stockOutlines : path or contours, optional
        Outlines of whole teeth that the reader's software offers, as another patient's tracing has them
        (:func:`ReadContours`): outlines that are one of them, moved, are templates, of which tip and axis count.
    landmarks3D : landmarks-like, optional
        On the scans, in their frame: they are predicted in the radiograph.
    landmarks2D : landmarks-like, optional
        Marked in the radiograph: only for measuring errors, nothing that registers sees them.
    exclude : sequence of str, optional
        Teeth to leave out of the tracing.
    fix : sequence of str, optional
        "scale", "rotation", "translation": what to hold.
    init : path or CaseResult, optional
        Where to start instead of searching: an alignment's file (``init`` of a case file), or an earlier result.
    views : sequence of dict, optional
        Radiographs beside the lateral one (Documentation/Views.md), each with a ``geometry`` (``direction="Frontal"`` for
        one from the front) and what was drawn on it: ``upperContour``, ``lowerContour``, ``cephalometricLandmarks``;
        further ``image`` or ``imageSize``, ``name`` ("frontal"), ``sameHeadPosition`` (True), ``principalPointSigma``
        (4 px).
    """

    def __init__(
        self,
        upper: Optional[MeshLike] = None,
        lower: Optional[MeshLike] = None,
        upperContour: Optional[ContourLike] = None,
        lowerContour: Optional[ContourLike] = None,
        contours: Optional[Any] = None,
        geometry: Optional[Any] = None,
        image: Optional[ImageLike] = None,
        imageSize: Optional[Tuple[int, int]] = None,
        principalPointKnown: Optional[bool] = None,
        tracedSide: Optional[str] = None,
        occlusion: str = "check",
        landmarks3D: Optional[LandmarksLike] = None,
        landmarks2D: Optional[LandmarksLike] = None,
        exclude: Sequence[str] = (),
        fix: Sequence[str] = (),
        cephalometricLandmarks: Optional[Any] = None,
        views: Sequence[Dict[str, Any]] = (),
        init: Optional[Union[PathLike, CaseResult]] = None,
        stockOutlines: Optional[Any] = None,
    ) -> None:
        if is_path(stockOutlines):
            from ._io import ReadContours

            stockOutlines = ReadContours(cast(PathLike, stockOutlines))[:2]
        if contours is not None:
            if upperContour is not None or lowerContour is not None:
                raise ArgumentError("give either contours or upperContour and lowerContour")
            if is_path(contours):
                from ._io import ReadContours

                contours = ReadContours(contours)
            upperContour, lowerContour = contours[0], contours[1]
            if imageSize is None and len(contours) > 2:
                imageSize = contours[2]
        known = None if geometry is None else as_geometry(geometry)
        if principalPointKnown is None:
            principalPointKnown = known is not None and tuple(known.GetPrincipalPoint()) != (0.0, 0.0)
        self._make(
            (
                None if upper is None else as_mesh(upper),
                None if lower is None else as_mesh(lower),
                None if upperContour is None else as_contour(upperContour, "upper"),
                None if lowerContour is None else as_contour(lowerContour, "lower"),
                known,
                None if image is None else as_image(image),
                imageSize or (0, 0),
                principalPointKnown,
                tracedSide,
                occlusion,
                None if cephalometricLandmarks is None else as_cephalometric_landmarks(cephalometricLandmarks),
                [as_contour(outlines) for outlines in stockOutlines or () if outlines is not None],
                None if landmarks3D is None else as_landmarks(landmarks3D, 3),
                None if landmarks2D is None else as_landmarks(landmarks2D, 2),
                list(exclude),
                list(fix),
            ),
            [self._take_view(**view) for view in views],
            _as_start(init),
        )

    def _make(self, parts: Tuple[Any, ...], views: list[Tuple[Any, ...]], start: Tuple[str, str] = ("", "")) -> None:
        self._native = _core._Case(*parts)
        for view in views:
            self._native._AddView(*view)
        if any(start):
            self._native._StartFrom(*start)
        self._result_file = ""
        # What it is made of, from which a pickle makes it again.
        self._made_of: Tuple[str, Tuple[Any, ...]] = ("parts", (parts, views, start))

    def _again(self, exclude: Optional[Sequence[str]], fix: Optional[Sequence[str]], start: Tuple[str, str]) -> Case:
        """The same case from another start, and where given with other teeth left out and other things held."""
        kind, words = self._made_of
        if kind != "parts":
            words = (
                list(words[0] if exclude is None else exclude or ["none"]),
                list(words[1] if fix is None else fix or ["none"]),
                *start,
            )
            return Case._read(self._get_source(), words)
        case = Case.__new__(Case)
        parts = list(words[0])
        if exclude is not None:
            parts[-2] = list(exclude)
        if fix is not None:
            parts[-1] = list(fix)
        case._make(tuple(parts), words[1], start)
        return case

    @staticmethod
    def _take_view(
        geometry: Any,
        upperContour: Optional[ContourLike] = None,
        lowerContour: Optional[ContourLike] = None,
        cephalometricLandmarks: Optional[Any] = None,
        image: Optional[ImageLike] = None,
        imageSize: Optional[Tuple[int, int]] = None,
        name: str = "frontal",
        sameHeadPosition: bool = True,
        principalPointSigma: float = 4.0,
    ) -> Tuple[Any, ...]:
        return (
            name,
            as_geometry(geometry),
            None if upperContour is None else as_contour(upperContour, "upper"),
            None if lowerContour is None else as_contour(lowerContour, "lower"),
            None if cephalometricLandmarks is None else as_cephalometric_landmarks(cephalometricLandmarks),
            None if image is None else as_image(image),
            imageSize or (0, 0),
            sameHeadPosition,
            principalPointSigma,
        )

    @classmethod
    def _of(cls, native: _core._Case, *words: Any) -> "Case":
        """A case that was read with these words: what to leave out, what to hold, where to start (file, text)."""
        case = cls.__new__(cls)
        case._native = native
        case._made_of = ("file", words or ([], [], "", ""))
        case._result_file = ""
        return case

    @classmethod
    def _read(cls, source: Tuple[str, str], words: Tuple[Any, ...]) -> "Case":
        """A case of its file, or of a "result" that options of the program made."""
        kind, name = source
        case = cls._of((_core._Case._ReadOfResult if kind == "result" else _core._Case._Read)(name, *words), *words)
        case._made_of = (kind, words)
        case._result_file = name if kind == "result" else ""
        return case

    def _get_source(self) -> Tuple[str, str]:
        kind = self._made_of[0]
        return kind, self._result_file if kind == "result" else self._native._GetFileName()

    def __copy__(self) -> "Case":
        case = Case.__new__(Case)
        case.__dict__.update(self.__dict__)
        return case

    def __getstate__(self) -> Dict[str, Any]:
        kind, words = self._made_of
        if kind == "parts":
            return {"kind": kind, "words": words}
        # Files are named and not carried along; what was in them is held against them where they are read again.
        exclude, fix, init, text = words
        init = os.path.abspath(init) if init and not text else init
        files = [os.path.abspath(self._get_source()[1]), list(exclude), list(fix), init, text]
        return {"kind": kind, "words": files, "inputs": [hashed for _, hashed in self._native._GetInputs()]}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        if state["kind"] == "parts":
            self._make(*state["words"])
            return
        self.__dict__.update(Case._read((state["kind"], state["words"][0]), tuple(state["words"][1:])).__dict__)
        now = self._native._GetInputs()
        if [hashed for _, hashed in now] != state["inputs"]:
            changed = [name for (name, hashed), then in zip(now, state["inputs"]) if hashed != then]
            raise ArgumentError(
                f"{changed[0] if changed else state['words'][0]} has changed since the case was pickled, which names its "
                "files and does not hold them; read the case again"
            )

    @property
    def upper(self) -> Optional[_core.Mesh]:
        """The upper scan, mm: shared, not copied."""
        return self._native._GetMesh(_core.Jaw.Upper)

    @property
    def lower(self) -> Optional[_core.Mesh]:
        """The lower scan, mm: shared, not copied."""
        return self._native._GetMesh(_core.Jaw.Lower)

    @property
    def upperContour(self) -> Optional[_core.Contour]:
        """The upper tracing: shared, not copied."""
        return self._native._GetContour(_core.Jaw.Upper)

    @property
    def lowerContour(self) -> Optional[_core.Contour]:
        """The lower tracing: shared, not copied."""
        return self._native._GetContour(_core.Jaw.Lower)

    @property
    def image(self) -> Optional[_core.Image]:
        """The radiograph: shared, not copied."""
        return self._native._GetImage()

    @property
    def imageSize(self) -> Tuple[int, int]:
        """(width, height) of the radiograph."""
        return self._native._GetImageSize()

    @property
    def geometry(self) -> _core.CephalometricGeometry:
        """The nominal geometry, a copy."""
        return copy.copy(self._native._GetGeometry())

    @property
    def landmarks3D(self) -> Dict[str, Array]:
        """On the scans, in the mesh files' unit; a copy."""
        return cast("Dict[str, Array]", self._native._GetLandmarks3D())

    @property
    def cephalometricLandmarks(self) -> Dict[str, Dict[str, Any]]:
        """Those to register with, each with its position and, where known, sigma_px and confidence; a copy."""
        return cast("Dict[str, Dict[str, Any]]", self._native._GetCephalometricLandmarks())

    @property
    def tracedSide(self) -> str:
        """What the tracing shows: as given, or as the drawing says."""
        return str(self._native._GetTracedSide())

    @property
    def warnings(self) -> list[str]:
        """What reading found odd."""
        return list(self._native._GetWarnings())

    def __repr__(self) -> str:
        parts = [
            name
            for name, value in (
                ("upper", self.upper),
                ("lower", self.lower),
                ("upper tracing", self.upperContour),
                ("lower tracing", self.lowerContour),
                ("cephalometric landmarks", self.cephalometricLandmarks or None),
                ("radiograph", self.image),
            )
            if value is not None
        ]
        return f"<dentalscr.Case {self._native._GetFileName()}: {', '.join(parts)}>"


def _as_start(init: Optional[Union[PathLike, CaseResult]]) -> Tuple[str, str]:
    """A start as (name, text): of a file the text is empty, of a result in memory the name is for messages."""
    if init is None:
        return "", ""
    if isinstance(init, CaseResult):
        return "earlier result", json.dumps(init._dict)
    return as_path(init), ""


def ReadCase(
    fileName: PathLike,
    exclude: Sequence[str] = (),
    fix: Sequence[str] = (),
    init: Optional[Union[PathLike, CaseResult]] = None,
) -> Case:
    """Reads a case file and every file that it names but its 2-D landmarks (Documentation/FileFormats.md).

    Parameters
    ----------
    fileName : path
    exclude : sequence of str, optional
        Teeth to leave out, besides those that the file says.
    fix : sequence of str, optional
        "scale", "rotation", "translation": what to hold, besides what the file says.
    init : path or CaseResult, optional
        Where to start instead of searching: an alignment's file, or an earlier result.
    """
    words = (list(exclude), list(fix), *_as_start(init))
    return Case._of(_core._Case._Read(as_path(fileName), *words), *words)


class DentalCaseReader(ProcessObject, _core.DentalCaseReader):
    """Reads a case file and every file that it names but its 2-D landmarks."""

    def Execute(self, fileName: Optional[PathLike] = None) -> Case:
        """Reads the file."""
        if fileName is not None:
            self.SetFileName(as_path(fileName))
        self._Update()
        return Case._of(self._TakeOutput())


class CaseLandmarkErrorFilter(ProcessObject, _core.CaseLandmarkErrorFilter):
    """Measures a result against the landmarks that were marked on its radiograph, where its case file names them."""

    def Execute(self, result: CaseResult) -> CaseResult:
        """The same result with the errors; without marks it is unchanged."""
        if result._native is None:
            raise ArgumentError("a result that was pickled has no case whose marks could be read; measure it where it was made")
        self._SetInput(result._native)
        self._Update()
        return CaseResult(self._TakeOutput())


def MeasureCaseLandmarkErrors(result: CaseResult) -> CaseResult:
    """Errors at the marked landmarks; see :class:`CaseLandmarkErrorFilter`. :func:`register` has measured them already."""
    return CaseLandmarkErrorFilter().Execute(result)


class CaseResultFolderWriter(ProcessObject, _core.CaseResultFolderWriter):
    """Writes everything that a case's result is made of into a folder, whole or not at all."""

    def Execute(self, result: CaseResult, folderName: Optional[PathLike] = None) -> None:
        """Writes a result; ``WriteReportOff`` leaves out what is for people, ``WritePageOff`` the page."""
        if folderName is not None:
            self.SetFolderName(as_path(folderName))
        if result._native is None:
            raise ArgumentError("a result that was pickled has no scans to write; write it where it was made")
        self._SetInput(result._native)
        self._Update()


def WriteCaseResult(
    result: CaseResult, folderName: PathLike, writeReport: bool = True, writePage: bool = True, anonymous: bool = False
) -> None:
    """Writes result.json, overlays, scans in the cephalostat frame, transforms and the page, all or nothing.

    Parameters
    ----------
    result : CaseResult
        Of :func:`register`.
    folderName : path
    writeReport : bool, optional
        With what is for people: overlays, scans in the cephalostat frame, the page.
    writePage : bool, optional
        With report.html, where there is a report.
    anonymous : bool, optional
        Without paths and names of files.
    """
    process = CaseResultFolderWriter()
    process.SetWriteReport(writeReport)
    process.SetWritePage(writePage)
    process.SetAnonymous(anonymous)
    process.Execute(result, folderName)


def WriteReportPage(
    result: PathLike, fileName: Optional[PathLike] = None, image: Optional[PathLike] = None, anonymous: bool = False
) -> list[str]:
    """Writes the page of a result that lies on disk: what ``dentalscr report`` does.

    Parameters
    ----------
    result : path
        Its folder, or its result.json.
    fileName : path, optional
        The page; report.html beside the result where it is not given.
    image : path, optional
        The radiograph, where it is not where the result says.
    anonymous : bool, optional
        Without paths and names of files.

    Returns
    -------
    list of str
        What is not there any more, and hence not on the page, a sentence each.
    """
    return _core._WriteReportPage(
        as_path(result), "" if fileName is None else as_path(fileName), "" if image is None else as_path(image), anonymous
    )


class CaseRegistration(ProcessObject, _core.CaseRegistration):
    """A case through the chain of a preset: axis, projection, contour, registration, landmarks, verdict."""

    def Execute(self, case: Union[Case, PathLike]) -> CaseResult:
        """Registers the case.

        Parameters
        ----------
        case : Case or path of a case file
        """
        given = case if isinstance(case, Case) else ReadCase(case)
        self._SetData(given._native)
        self._Update()
        result = CaseResult(self._TakeResult(given._native))
        result._case = given
        return result


def register(
    case: Union[Case, PathLike, Mapping[str, Any]],
    output: Optional[PathLike] = None,
    *,
    preset: Union[str, _core.Preset] = "robust",
    exclude: Sequence[str] = (),
    fix: Sequence[str] = (),
    init: Optional[Union[PathLike, CaseResult]] = None,
    silhouette: str = "drr",
    options: Optional[Mapping[str, Any]] = None,
    threads: Optional[int] = None,
    progress: Optional[Callable[[float, str], object]] = None,
    page: bool = True,
    anonymous: bool = False,
) -> CaseResult:
    """Registers a case: what ``dentalscr register`` does.

    Parameters
    ----------
    case : path, Case or dict
        A case file, a :class:`Case`, or the keywords of one.
    output : path, optional
        Folder for result.json, overlays, scans, transforms and the page.
    preset : "robust", "paper", "bounding-box" or "single-stage"
    exclude : sequence of str, optional
        Teeth to leave out, e.g. "UR8". For a case file or keywords.
    fix : sequence of str, optional
        "scale", "rotation", "translation". For a case file or keywords.
    init : path or CaseResult, optional
        Where to start instead of searching: an alignment's file, or an earlier result. For a case file or keywords;
        :func:`register_from` goes on from a result with what it was registered with.
    silhouette : "drr" or "mesh"
        Where the paper's silhouette comes from. What a preset has no use for is among the result's ``warnings``.
    options : dict, optional
        Ingredients of preset robust by name (Documentation/Robust.md), e.g. ``{"useRobustKernel": False}``.
    threads : int, optional
        The result is the same for any number.
    progress : callable, optional
        Called with the share that is done and the stage's name.
    page : bool, optional
        Write report.html, the page to judge the case by, into the folder.
    anonymous : bool, optional
        Leave paths and names of files out of what is written.

    Returns
    -------
    CaseResult
        ``to_dict()`` equals result.json.

    Raises
    ------
    InputError
        For unusable input. A jaw that can't be registered is no error: see its ``status`` and ``reasons``.
    """
    if isinstance(case, Mapping):
        more: Dict[str, Any] = {"exclude": [*case.get("exclude", ()), *exclude], "fix": [*case.get("fix", ()), *fix]}
        if init is not None:
            more["init"] = init
        given = Case(**{**case, **more})
    elif isinstance(case, Case):
        if exclude or fix or init is not None:
            raise ArgumentError("exclude, fix and init belong to the making of the Case")
        given = case
    else:
        given = ReadCase(case, exclude, fix, init)
    if silhouette not in ("drr", "mesh"):
        raise ArgumentError(f'silhouette is "drr" or "mesh", not {silhouette!r}')
    registration = CaseRegistration()
    registration.SetPreset(as_preset(preset))
    registration.SetUseSurfaceDRR(silhouette == "drr")
    if options:
        if registration.GetPreset() != _core.Preset.Robust:
            raise ArgumentError(f"preset {preset} has no options")
        for name, value in options.items():
            registration.SetOption(f"{name}={as_option(value)}")
    registration.SetNumberOfWorkUnits(threads or _core.ProcessObject.GetGlobalDefaultNumberOfThreads())
    if progress is not None:
        call = progress
        registration.AddCommand(
            sitkProgressEvent, lambda: call(registration.GetProgress(), registration.GetCurrentStage())
        )
    result = registration.Execute(given)
    if output is not None:
        result.Write(output, page=page, anonymous=anonymous)
    return result


def register_from(
    result: Union[PathLike, CaseResult],
    output: Optional[PathLike] = None,
    *,
    case: Optional[Union[Case, PathLike, Mapping[str, Any]]] = None,
    exclude: Optional[Sequence[str]] = None,
    fix: Optional[Sequence[str]] = None,
    options: Optional[Mapping[str, Any]] = None,
    threads: Optional[int] = None,
    progress: Optional[Callable[[float, str], object]] = None,
    page: bool = True,
    anonymous: bool = False,
) -> CaseResult:
    """Registers an earlier result's case again, in the place where that one ended, as ``dentalscr register --from``.

    After a "suspect" correct a tooth's tracing, leave a tooth out, hold or free something. What the first run was told
    holds on unless something else is said here. Other readings of the drawing are not tried beside a start.

    Parameters
    ----------
    result : CaseResult or path
        Of :func:`register`, or its folder or result.json.
    output : path, optional
        Folder for result.json, overlays, scans, transforms and the page.
    case : path, Case or dict, optional
        The case, where it was corrected in memory or its file has another name. Default: the result's own; of a file the
        file as it is now.
    exclude : sequence of str, optional
        Teeth to leave out in place of those that the first run left out: ``[]`` takes them back.
    fix : sequence of str, optional
        "scale", "rotation", "translation", in place of what the first run held: ``[]`` frees it.
    options : dict, optional
        Ingredients of preset robust on top of the first run's.
    threads, progress, page, anonymous
        As of :func:`register`.

    Returns
    -------
    CaseResult

    Raises
    ------
    InputError
        Where the result or its case cannot be read, and where the result has no pose, as those of the paper's presets.
    """
    start = _as_start(result)
    if isinstance(result, CaseResult):
        before, given = result.to_dict(), result._case
        if case is None and given is None:
            raise ArgumentError("a result that was pickled has no case with it; give case, or the folder of the result")
        control = before.get("control", {})
        excluded, fixed, earlier = control.get("exclude", []), control.get("fix", []), before.get("options", [])
        landmarks, source = "", ("", "")
    else:
        found = _core._ReadContinuation(start[0], case is None)
        excluded, fixed, earlier, given = found["exclude"], found["fix"], found["options"], None
        landmarks = found["landmarks"]
        source = ("file", found["case"]) if found["case"] else ("result", found["result"])
    # An empty list takes back what the case file says, too, as "none" does on the command line.
    exclude = (list(excluded) or None) if exclude is None else list(exclude)
    fix = (list(fixed) or None) if fix is None else list(fix)
    if case is None and given is not None:
        again = given._again(exclude, fix, start)
    elif isinstance(case, Case):
        again = case._again(exclude, fix, start)
    elif isinstance(case, Mapping):
        again = Case(**{**case, "exclude": exclude or [], "fix": fix or [], "init": result})
    else:
        words = ([] if exclude is None else exclude or ["none"], [] if fix is None else fix or ["none"], *start)
        if case is None and source[0] == "result":
            again = Case._read(source, words)
        else:
            again = Case._of(_core._Case._Read(source[1] if case is None else as_path(case), *words, landmarks), *words)
    merged: Dict[str, Any] = dict(assignment.split("=", 1) for assignment in earlier)
    merged.update(options or {})
    return register(again, output, options=merged, threads=threads, progress=progress, page=page, anonymous=anonymous)


def as_preset(preset: Union[str, _core.Preset]) -> _core.Preset:
    """A preset by its name in the command line's spelling or in that of the enumeration."""
    return _core.Preset(preset.replace("-", "")) if isinstance(preset, str) else preset


def as_option(value: Any) -> str:
    """A value in the command line's spelling: on, off, numbers with commas."""
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, (list, tuple, np.ndarray)):
        return ",".join(as_option(item) for item in value)
    return repr(float(value)) if isinstance(value, (float, np.floating)) else str(value)
