# What the module offers, for editors and type checkers; handlebody.Contour is where to begin.
import os
import typing as _t

import numpy as _np
import numpy.typing as _npt

__version__: str
__all__ = [
    "Contour",
    "Error",
    "Grid",
    "HandlebodyWarning",
    "InputError",
    "Mesh",
    "OutputError",
    "Phantom",
    "SeedError",
    "UsageError",
    "Volume",
    "compare",
    "phantom",
    "read_mesh",
    "read_volume",
    "set_decoder",
]

_Path = _t.Union[str, bytes, "os.PathLike[str]"]
_Numbers = _t.Union[_t.Sequence[float], _npt.NDArray[_t.Any]]
_Clicks = _t.Union[str, _Numbers, _t.Sequence[_t.Union[str, _Numbers]], None]
_StopReason = _t.Literal["running", "converged", "max-iterations", "empty", "frozen", "stuck", "given"]
_Space = _t.Literal["LPS", "RAS"]

class _Topology(_t.TypedDict):
    components: int
    genus: int
    euler: int

class _Event(_t.TypedDict):
    kind: str
    iteration: int
    location: list[float]
    fronts: int
    loop_sizes: list[int]
    before: _Topology
    after: _Topology
    reason: str

class _Disc(_t.TypedDict):
    centre: list[float]
    normal: list[float]
    radius: float

class _Leak(_t.TypedDict):
    iteration: int
    location: list[float]
    width_mm: _t.Optional[float]
    width_before_mm: float
    width_behind_mm: float
    disc: _Disc
    option: str
    wall_disc: str
    sentence: str

class _Step(_t.TypedDict):
    iteration: int
    moved_vertices: int
    settled_vertices: int
    volume_mm3: float
    largest_move_mm: float
    events: list[_Event]
    leaks: list[_Leak]

class _Certificate(_t.TypedDict):
    vertices: int
    faces: int
    components: int
    genus: list[int]
    euler: int
    volume_mm3: float
    area_mm2: float
    closed: bool
    manifold: bool
    oriented: bool
    self_intersections: int
    cavities: int
    misplaced_components: int

class _Intensity(_t.TypedDict):
    voxels: int
    mean: float
    standard_deviation: float
    minimum: float
    maximum: float

class _Measures(_t.TypedDict):
    volume_mm3: float
    area_mm2: float
    centroid: list[float]
    largest_diameter_mm: float
    largest_diameter_ends: list[list[float]]
    principal_extents_mm: list[float]
    principal_axes: list[list[float]]
    box_mm: list[float]
    intensity: _t.Optional[_Intensity]

class Error(Exception): ...
class InputError(Error, ValueError): ...
class OutputError(Error, OSError): ...
class UsageError(Error, ValueError): ...
class SeedError(Error, ValueError): ...
class HandlebodyWarning(UserWarning): ...

class Grid:
    def __init__(
        self,
        size: _t.Sequence[int],
        spacing: _Numbers = (1, 1, 1),
        origin: _Numbers = (0, 0, 0),
        direction: _t.Optional[_npt.ArrayLike] = None,
    ) -> None: ...
    @property
    def size(self) -> tuple[int, int, int]: ...
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def spacing(self) -> tuple[float, float, float]: ...
    @property
    def origin(self) -> tuple[float, float, float]: ...
    @property
    def direction(self) -> _npt.NDArray[_np.float64]: ...
    def to_world(self, index: _Numbers) -> tuple[float, float, float]: ...
    def to_index(self, world: _Numbers) -> tuple[float, float, float]: ...

class Volume:
    def __init__(
        self,
        array: _npt.ArrayLike,
        spacing: _Numbers = (1, 1, 1),
        origin: _Numbers = (0, 0, 0),
        direction: _t.Optional[_npt.ArrayLike] = None,
    ) -> None: ...
    @property
    def array(self) -> _npt.NDArray[_t.Any]: ...
    @property
    def grid(self) -> Grid: ...
    @property
    def path(self) -> _t.Optional[str]: ...
    @property
    def frames(self) -> int: ...
    @property
    def calibrated(self) -> bool: ...
    @property
    def warnings(self) -> list[str]: ...
    def save(self, path: _Path) -> None: ...

class Phantom:
    @property
    def name(self) -> str: ...
    @property
    def volume(self) -> Volume: ...
    @property
    def truth(self) -> Volume: ...
    @property
    def seed(self) -> tuple[float, float, float, float]: ...
    @property
    def genus(self) -> list[int]: ...

class Mesh:
    def __init__(self, vertices: _npt.ArrayLike, faces: _npt.ArrayLike) -> None: ...
    @property
    def vertices(self) -> _npt.NDArray[_np.float64]: ...
    @property
    def faces(self) -> _npt.NDArray[_np.int32]: ...
    def certificate(self) -> _Certificate: ...
    def measure(self, volume: _t.Optional[Volume] = None) -> _Measures: ...
    def label_map(self, grid: _t.Union[Grid, Volume]) -> _npt.NDArray[_np.uint8]: ...
    def save(
        self,
        path: _Path,
        *,
        volume: _t.Optional[Volume] = None,
        space: _Space = "LPS",
        name: str = "",
        label: int = 1,
    ) -> None: ...

class Contour:
    def __init__(
        self,
        volume: Volume,
        *,
        seed: _Clicks = None,
        seed_ijk: _Clicks = None,
        background: _Clicks = None,
        background_ijk: _Clicks = None,
        object: _t.Optional[_t.Literal["auto", "dark", "bright"]] = None,
        range: _t.Union[str, _Numbers, None] = None,
        candidate: _t.Optional[int] = None,
        smoothing: _t.Union[float, _t.Literal["auto"], None] = None,
        edge_length: _t.Optional[float] = None,
        direction: _t.Optional[_t.Literal["outward", "both"]] = None,
        balloon: _t.Optional[float] = None,
        curvature: _t.Optional[float] = None,
        max_iterations: _t.Optional[int] = None,
        threads: _t.Optional[int] = None,
        broad_phase: _t.Optional[_t.Literal["hashing", "sorted"]] = None,
        resolution: _t.Optional[_t.Literal["auto", "adaptive", "uniform"]] = None,
        wall: _Clicks = None,
        wall_disc: _Clicks = None,
        walls: _t.Optional[_Path] = None,
        start: _t.Optional[_Path] = None,
        given: _t.Optional[_Path] = None,
        start_label: _t.Union[int, str, None] = None,
        start_smooth: _t.Optional[float] = None,
        start_keep_largest: _t.Optional[_t.Literal["on", "off"]] = None,
        start_genus: _t.Optional[int] = None,
        veto: _t.Union[str, _t.Sequence[str], None] = None,
        pin: _t.Union[str, _t.Sequence[str], None] = None,
        edit: _t.Union[str, _t.Sequence[str], None] = None,
        components: _t.Optional[int] = None,
        genus: _t.Optional[int] = None,
        allow: _Clicks = None,
        hold: _Clicks = None,
    ) -> None: ...
    def step(self) -> _Step: ...
    def run(self, max_steps: _t.Optional[int] = None, *, until_leak: bool = False) -> _StopReason: ...
    def change(
        self,
        *,
        seed: _Clicks = None,
        seed_ijk: _Clicks = None,
        background: _Clicks = None,
        background_ijk: _Clicks = None,
        object: _t.Optional[_t.Literal["auto", "dark", "bright"]] = None,
        range: _t.Union[str, _Numbers, None] = None,
        candidate: _t.Optional[int] = None,
        smoothing: _t.Union[float, _t.Literal["auto"], None] = None,
        edge_length: _t.Optional[float] = None,
        direction: _t.Optional[_t.Literal["outward", "both"]] = None,
        balloon: _t.Optional[float] = None,
        curvature: _t.Optional[float] = None,
        max_iterations: _t.Optional[int] = None,
        threads: _t.Optional[int] = None,
        broad_phase: _t.Optional[_t.Literal["hashing", "sorted"]] = None,
        resolution: _t.Optional[_t.Literal["auto", "adaptive", "uniform"]] = None,
        wall: _Clicks = None,
        wall_disc: _Clicks = None,
        walls: _t.Optional[_Path] = None,
        start: _t.Optional[_Path] = None,
        given: _t.Optional[_Path] = None,
        start_label: _t.Union[int, str, None] = None,
        start_smooth: _t.Optional[float] = None,
        start_keep_largest: _t.Optional[_t.Literal["on", "off"]] = None,
        start_genus: _t.Optional[int] = None,
        veto: _t.Union[str, _t.Sequence[str], None] = None,
        pin: _t.Union[str, _t.Sequence[str], None] = None,
        edit: _t.Union[str, _t.Sequence[str], None] = None,
        components: _t.Optional[int] = None,
        genus: _t.Optional[int] = None,
        allow: _Clicks = None,
        hold: _Clicks = None,
    ) -> None: ...
    def copy(self) -> Contour: ...
    @property
    def iteration(self) -> int: ...
    @property
    def stop_reason(self) -> _StopReason: ...
    @property
    def events(self) -> list[_Event]: ...
    @property
    def leaks(self) -> list[_Leak]: ...
    @property
    def parameters(self) -> dict[str, _t.Any]: ...
    @property
    def vertices(self) -> _npt.NDArray[_np.float64]: ...
    @property
    def faces(self) -> _npt.NDArray[_np.int32]: ...
    def mesh(self) -> Mesh: ...
    def certificate(self) -> _Certificate: ...
    def measure(self) -> _Measures: ...
    def warnings(self) -> list[str]: ...
    def report(self) -> dict[str, _t.Any]: ...
    def label_map(self, grid: _t.Union[Grid, Volume, None] = None) -> _npt.NDArray[_np.uint8]: ...
    def save(self, *paths: _Path, space: _Space = "LPS", name: str = "", label: int = 1) -> None: ...
    def save_session(self, path: _Path) -> None: ...

def read_volume(
    path: _Path,
    *,
    series: _t.Optional[str] = None,
    frame: _t.Optional[int] = None,
    spacing: _t.Optional[_Numbers] = None,
    uneven: _t.Literal["resample", "refuse"] = "resample",
) -> Volume: ...
def read_mesh(path: _Path) -> Mesh: ...
def phantom(
    name: str,
    *,
    size: _t.Sequence[int] = (0, 0, 0),
    spacing: _Numbers = (1, 1, 1),
    rotate: _Numbers = (0, 0, 0),
    type: _t.Literal["uint8", "int16", "float32"] = "uint8",
    noise: float = -1,
    bias: float = 1,
    gap: float = 0,
    random_seed: int = 1,
) -> Phantom: ...
def compare(
    a: _t.Union[Mesh, Volume, _Path],
    b: _t.Union[Mesh, Volume, _Path],
    *,
    label: _t.Optional[int] = None,
    label_a: _t.Optional[int] = None,
    label_b: _t.Optional[int] = None,
    sampling: _t.Optional[float] = None,
    threads: int = 1,
) -> dict[str, _t.Any]: ...
def set_decoder(program: _Path) -> None: ...
