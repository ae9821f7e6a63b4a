"""What comes out of a registered case."""
from __future__ import annotations

import base64
import copy
import html
import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, cast

import numpy as np

from . import _core
from ._errors import ArgumentError
from ._inputs import Array, PathLike, as_path
from ._pose_downstream import RegistrationFinding
from ._scene import parts_of, to_multiblock

if TYPE_CHECKING:
    from ._case import Case


@dataclass(frozen=True)
class Middle:
    """The middle of a right and a left point's images, which is what a cephalometric analysis marks."""

    #: (u, v), pixels.
    position: Array
    #: Standard deviation an axis, pixels: of the jaw's place, and of the point's on the scan where nobody marked it there.
    sigma: float
    #: How the points were found on the scan: "landmarks_3d", "tooth labels", "the traced tooth", "its place on the other
    #: side", "its place along the arch".
    found_by: str


@dataclass(frozen=True, repr=False)
class JawResult:
    """One registered jaw. Names say the direction: ``T_b_from_a`` maps points of a to b."""

    status: str
    reasons: Tuple[str, ...]
    #: The same for programs: ``code``, ``severity``, ``text``, ``value``, ``limit``, ``unit``.
    findings: Tuple[RegistrationFinding, ...]
    registered: bool
    #: (3, 4): mesh file (its unit) to homogeneous pixel index.
    P_pixel_from_mesh: Array
    #: (4, 4), rigid, mm.
    T_umda_from_mesh: Array
    #: (4, 4), rigid, mm.
    T_cephalostat_from_mesh: Array
    #: The geometry's own projection q (pixels) to the radiograph's pixels.
    similarity: Optional[_core.Similarity2DTransform]
    metrics: Dict[str, Any]
    #: Predicted places in the radiograph, pixels.
    landmarks: Dict[str, Array]
    #: Standard deviation an axis, pixels, where the method has one.
    landmark_sigma: Dict[str, float]
    #: (2, 2), square pixels, where the method has one.
    landmark_covariance: Dict[str, Array]
    #: Middles of both sides by name ("U6_MB"), where these are what was drawn or the scan has no landmarks; preset robust.
    middles: Dict[str, Middle]
    #: Distance of the tracing from the contour that it lies on, pixels; None where the method does not know it.
    fit: Optional[float]
    #: Distance that a landmark is expected to be off by, pixels; None where the method has no covariance.
    expected_error: Optional[float]
    #: The jaw that placed this one, "upper" or "lower", where nothing was drawn of it and the scans share a frame; else None.
    placed_by: Optional[str]
    #: Landmark errors, pixels; None without 2-D landmarks.
    error: Optional[Dict[str, Any]]
    #: Aligned contours in the radiograph by name, "whole" among them.
    contours: Dict[str, _core.Contour]

    def __repr__(self) -> str:
        return f"<dentalscr.JawResult {self._figures()}>"

    def _figures(self) -> str:
        text = self.status
        if self.placed_by is not None:
            text += f", placed by the {self.placed_by} jaw"
        if self.fit is not None:
            text += f", fit {self.fit:.2f} px"
        elif self.registered and self.metrics and self.expected_error is None:
            text += f", Chamfer {self.metrics['chamfer_px']:.2f} px"
        if self.expected_error is not None:
            text += f", expected error {self.expected_error:.2f} px"
        if self.error is not None:
            text += f", landmark error {self.error['mean_px']:.2f} px"
        return text

    def project(self, points: Any) -> Array:
        """Where points of the mesh file (N, 3) are in the radiograph: (N, 2) continuous pixel indices."""
        array = np.asarray(points, dtype=np.float64).reshape(-1, 3)
        rows = array @ self.P_pixel_from_mesh[:, :3].T + self.P_pixel_from_mesh[:, 3]
        return cast(Array, rows[:, :2] / rows[:, 2:])


@dataclass(frozen=True, repr=False)
class ViewResult:
    """What a further radiograph of a registered case shows (Documentation/Views.md)."""

    name: str
    #: "frontal" or "lateral".
    direction: str
    #: "ok", or "suspect" where a finding says why.
    status: str
    findings: Tuple[RegistrationFinding, ...]
    same_head_position: bool
    #: By jaw, as in ``views`` of result.json: ``projection_3x4``, ``landmarks_px``, ``landmark_sigma_px``, ``head_moved``,
    #: ``scale_factor``, ...
    jaws: Dict[str, Dict[str, Any]]

    def __repr__(self) -> str:
        return f"<dentalscr.ViewResult {self.name}, {self.direction}, {self.status}: {', '.join(self.jaws)}>"

    def project(self, jaw: str, points: Any) -> Array:
        """Where points of a jaw's mesh file (N, 3) are on this radiograph: (N, 2) continuous pixel indices."""
        matrix = np.array(self.jaws[jaw]["projection_3x4"], dtype=np.float64)
        rows = np.asarray(points, dtype=np.float64).reshape(-1, 3) @ matrix[:, :3].T + matrix[:, 3]
        return cast(Array, rows[:, :2] / rows[:, 2:])


class CaseResult:
    """What a registered case is. Looks well in a notebook; pickles (without the scans)."""

    def __init__(self, native: _core._CaseResult) -> None:
        self._native: Optional[_core._CaseResult] = native
        #: What was registered, and with which options: for register_from().
        self._case: Optional[Case] = None
        self._dict = cast("Dict[str, Any]", json.loads(native._ToJson()))
        self._pictures: Dict[str, bytes] = {}
        self.geometry: Optional[_core.CephalometricGeometry] = native._GetGeometry()
        self.jaws: Dict[str, JawResult] = {name: self._make_jaw(native, name) for name in native._GetJaws()}

    def _make_jaw(self, native: _core._CaseResult, name: str) -> JawResult:
        entry = self._dict["jaws"][name]
        values = native._GetJaw(name)
        registered = bool(values["registered"])
        similarity = None
        if registered:
            numbers = entry["similarity"]
            similarity = _core.Similarity2DTransform(
                numbers["scale"], numbers["rotation_rad"], tuple(numbers["translation_px"])
            )
        return JawResult(
            status=entry["status"],
            reasons=tuple(entry["reasons"]),
            findings=tuple(RegistrationFinding(**each) for each in entry["findings"]),
            registered=registered,
            P_pixel_from_mesh=values["projection"],
            T_umda_from_mesh=values["meshToUMDA"],
            T_cephalostat_from_mesh=values["meshToCephalostat"],
            similarity=similarity,
            metrics=dict(entry.get("metrics", {})),
            landmarks={key: np.array(point) for key, point in entry.get("landmarks_px", {}).items()},
            landmark_sigma=dict(entry.get("landmark_sigma_px", {})),
            landmark_covariance=dict(values["covariances"]),
            middles={
                key: Middle(np.array(each["position"]), float(each["sigma_px"]), str(each["found_by"]))
                for key, each in entry.get("middles", {}).items()
            },
            fit=entry.get("metrics_matched", {}).get("chamfer_px"),
            expected_error=entry.get("expected_error_px"),
            placed_by=entry.get("placed_by"),
            error=entry.get("error"),
            contours=dict(values["contours"]),
        )

    @property
    def status(self) -> str:
        """ "ok", "suspect" (a person should look) or "failed": the worst of the jaws."""
        return str(self._dict["status"])

    @property
    def preset(self) -> str:
        """Name of the chain that ran: "robust" or one of the paper's."""
        return str(self._dict["preset"])

    @property
    def views(self) -> Dict[str, ViewResult]:
        """Radiographs beside the lateral one, by name."""
        return {
            name: ViewResult(
                name=name,
                direction=view["direction"],
                status=view["status"],
                findings=tuple(RegistrationFinding(**each) for each in view["findings"]),
                same_head_position=view["same_head_position"],
                jaws=view["jaws"],
            )
            for name, view in self._dict.get("views", {}).items()
        }

    @property
    def skipped(self) -> Dict[str, str]:
        """Jaws that lack a scan or a tracing, with the reason."""
        return dict(self._dict["skipped"])

    @property
    def warnings(self) -> list[str]:
        """What a person should know of the input, a sentence each."""
        return list(self._dict["warnings"])

    @property
    def middles(self) -> Dict[str, Middle]:
        """Middles of both sides of the jaws' teeth, by name: "U1_tip", "L6_MB"."""
        return {name: middle for jaw in self.jaws.values() for name, middle in jaw.middles.items()}

    @property
    def upper(self) -> JawResult:
        """The upper jaw's result; an error is raised where the case has no such jaw."""
        return self._jaw("upper")

    @property
    def lower(self) -> JawResult:
        """The lower jaw's result; an error is raised where the case has no such jaw."""
        return self._jaw("lower")

    def _jaw(self, name: str) -> JawResult:
        if name not in self.jaws:
            raise ArgumentError(f"there is no {name} jaw: {self.skipped.get(name, 'it was not given')}")
        return self.jaws[name]

    def to_dict(self) -> Dict[str, Any]:
        """What result.json holds (Documentation/FileFormats.md); a copy."""
        return copy.deepcopy(self._dict)

    def Write(self, folder: PathLike, *, report: bool = True, page: bool = True, anonymous: bool = False) -> None:
        """Writes result.json, overlays, scans in the cephalostat frame, transforms and the page, all or nothing.

        Parameters
        ----------
        folder : path
        report : bool, optional
            With what is for people: overlays, scans, the page.
        page : bool, optional
            With report.html, the page to judge the case by.
        anonymous : bool, optional
            Without paths and names of files.
        """
        if self._native is None:
            raise ArgumentError("a result that was pickled has no scans to write; write it where it was made")
        self._native._Write(as_path(folder), report, page, anonymous)

    def GetOverlayImage(self, jaw: str = "upper") -> _core.Picture:
        """Radiograph, tracing, aligned silhouette and landmarks of a jaw as a picture."""
        self._jaw(jaw)
        if self._native is None:
            raise ArgumentError("a result that was pickled keeps its pictures only as PNG; see overlay_png()")
        return self._native._GetOverlay(jaw)

    def overlay_png(self, jaw: str = "upper") -> bytes:
        """The same as the bytes of a PNG."""
        self._jaw(jaw)
        if jaw not in self._pictures:
            self._pictures[jaw] = self.GetOverlayImage(jaw)._repr_png_()
        return self._pictures[jaw]

    def scene(self, kind: str = "vtk") -> Any:
        """The case in space: scans, their frames, source, central ray, and the radiograph on its detector.

        Parameters
        ----------
        kind : "vtk", "pyvista" or "arrays"
            A ``vtkMultiBlockDataSet`` or a ``pyvista.MultiBlock``, made by what is installed for this Python, in which
            each part is a block of its name; or a list of :class:`ScenePart`, which needs neither. It is the scene
            that ``dentalscr view`` shows (Documentation/Scene.md).
        """
        if kind not in ("vtk", "pyvista", "arrays"):
            raise ArgumentError(f'there is no scene of kind "{kind}"; use "vtk", "pyvista" or "arrays"')
        if self._native is None:
            raise ArgumentError("a result that was pickled has no scans to show; make its scene where it was made")
        parts = parts_of(self._native._GetScene())
        if kind == "arrays":
            return parts
        try:
            blocks = to_multiblock(parts)
            if kind == "vtk":
                return blocks
            import pyvista

            return pyvista.wrap(blocks)
        except ImportError as problem:
            package = "pyvista" if kind == "pyvista" else "vtk"
            raise ArgumentError(
                f'a scene of kind "{kind}" needs {package} ({problem}): pip install {package}, or use kind "arrays"'
            ) from problem

    def __repr__(self) -> str:
        lines = [f"<dentalscr.CaseResult {self.status}, preset {self.preset}"]
        for name, jaw in self.jaws.items():
            text = f"  {name}: {jaw._figures()}"
            for reason in jaw.reasons:
                text += f"\n    {reason}"
            lines.append(text)
        lines += [f"  {name}: skipped, {reason}" for name, reason in self.skipped.items()]
        return "\n".join(lines) + ">"

    def _repr_html_(self) -> str:
        rows = []
        for name, jaw in self.jaws.items():
            error = "" if jaw.error is None else f"{jaw.error['mean_px']:.2f}"
            fit = "" if jaw.fit is None else f"{jaw.fit:.2f}"
            expected = "" if jaw.expected_error is None else f"{jaw.expected_error:.2f}"
            reasons = "<br>".join(html.escape(reason) for reason in jaw.reasons)
            rows.append(
                f"<tr><td>{name}</td><td><b>{jaw.status}</b></td><td>{fit}</td><td>{expected}</td><td>{error}</td><td>{reasons}</td></tr>"
            )
        for name, reason in self.skipped.items():
            rows.append(f"<tr><td>{name}</td><td>skipped</td><td></td><td></td><td></td><td>{html.escape(reason)}</td></tr>")
        pictures = "".join(
            f'<img alt="{name}" style="max-width:100%" src="data:image/png;base64,'
            f'{base64.b64encode(self.overlay_png(name)).decode()}">'
            for name, jaw in self.jaws.items()
            if jaw.registered
        )
        return (
            f"<div><p>Registration by preset {html.escape(self.preset)}: <b>{self.status}</b></p><table><tr><th>jaw</th>"
            "<th>status</th><th>fit px</th><th>expected error px</th><th>landmark error px</th><th>reasons</th></tr>"
            f"{''.join(rows)}</table>{pictures}</div>"
        )

    def __getstate__(self) -> Dict[str, Any]:
        for name, jaw in self.jaws.items():
            if jaw.registered:
                self.overlay_png(name)
        state = dict(self.__dict__)
        state["_native"] = None
        state["_case"] = None
        return state

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
