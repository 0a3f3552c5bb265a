"""`Scene`: a ball among bodies, checked when it is made.

Nothing is derived, and SymPy is not imported, before `Scene.derive`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from hoopgen.core.parameters import ParameterValues, Value
from hoopgen.text.shorten import brief

from .contact_laws import CONTACT_ARGUMENTS
from .errors import unknown, wrong
from .inputs import Input
from .limits import Limits, check_limits, use_limits
from .pieces import Body, Direction, End, Parameter, Size
from .scene_reader import ParsedScene, read_scene

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene as Derived


@dataclass(frozen=True)
class Scene:
    """A ball among bodies.

    Attributes
    ----------
    name
        As that of a parameter.
    parameters
        In calling order.
    bodies
        In the order of the results' columns.
    ends
        By name, in order: where a shot is, of those that it crosses at once, the first counts. It
        may be empty: a time ends such shots.
    ball_radius, gravity
        Sizes, too. Gravity may be the number 0, or a parameter that is nonnegative.
    inertia
        A size, too: the ball's moment of inertia over m R_B², 2/3 of a thin shell, 2/5 of a solid
        ball; 1/64 to 1.
    down
        Where gravity points, "-z" or along another axis, or in any direction: three sizes, of any
        length but 0, or the angles ``{"tilt": "170deg", "towards": "30deg"}`` from the z axis.
    restitution
        That of bodies without one of their own.
    friction, tangential, restitution_speed
        The same; infinite, 0 and infinite, as in the article, where there is none.
    rolls
        Whether a ball whose bounces become ever smaller rolls on, instead of bouncing until it is
        given up. Off the edges of a body, where its bounds or its span end, it flies, unless
        another body takes it over there. Then tori have no bounds, others have bounds of a degree
        of at most 2, no body is a revolution or a surface of your own, and gravity is not zero, in
        whatever direction. Such a shot may end LODGED, at rest or wedged, or ENDLESS, still rolling
        at the time limit. It makes kernels some times as long to compile.
    air
        Whether the ball flies through air, with drag, buoyancy and the Magnus force of its spin.
        Then the scene has five parameters more, which it may declare itself to give other defaults:
        `ball_mass` (0.624 kg), `air_density` (1.2 kg/m³), `drag_coefficient` (0.5),
        `lift_coefficient` (0.6) and `drag_smoothing_speed` (0.05 m/s). Where a ball
        rolls, the air presses it on or lifts it off, and no air acts along the surface.
    axes, remarks
        For readers, in plain sentences: where origin and axes lie, and what else there is to say.
    limits
        How large the scene may be, `hoopgen.scene.Limits`, or a mapping of those that are raised:
        ``{"parameters": 500}``. A scene file cannot set them.
    text
        The text of the file that it was read from; empty of a scene that was made otherwise.

    Raises
    ------
    SceneError
        If something is wrong with it; names the body and the argument.
    """

    name: str
    _: KW_ONLY
    parameters: Sequence[Parameter] = ()
    bodies: Sequence[Body]
    ends: Mapping[str, End] = field(default_factory=dict)
    ball_radius: Size
    gravity: Size
    inertia: Size = "2/3"
    down: str | Direction = "-z"
    restitution: Size | None = None
    friction: Size | None = None
    tangential: Size | None = None
    restitution_speed: Size | None = None
    rolls: bool = False
    air: bool = False
    axes: str = ""
    remarks: str = ""
    limits: Limits | Mapping[str, int] | None = field(default=None, compare=False, repr=False)
    text: str = field(default="", init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "limits", check_limits(self.limits))
        try:
            _ = self.read  # what is wrong is refused now
        except RecursionError:
            said = "its formulas are nested too deep for Python's recursion limit"
            raise wrong(self.name, "", "", said) from None

    @cached_property
    def read(self) -> ParsedScene:
        """The whole scene, as formulas."""
        return self._read()

    def _read(self, as_written: bool = False) -> ParsedScene:
        """Return the whole scene as formulas; for readers, with every size as it was given."""
        with use_limits(check_limits(self.limits)):
            return read_scene(
                self.name,
                parameters=self.parameters,
                bodies=self.bodies,
                ends=self.ends,
                ball_radius=self.ball_radius,
                gravity=self.gravity,
                inertia=self.inertia,
                down=self.down,
                rolls=self.rolls,
                air=self.air,
                contacts={name: getattr(self, name) for name in CONTACT_ARGUMENTS},
                as_written=as_written,
            )

    def __hash__(self) -> int:
        return hash(self.key)

    @cached_property
    def key(self) -> str:
        """The identity of what is derived, as text, the same in any process."""
        return repr((self.read, self.axes, self.remarks))

    @property
    def inputs(self) -> tuple[Input, ...]:
        """The parameters, then the sizes computed from them, as kernels take them."""
        return self.read.inputs

    @property
    def defaults(self) -> dict[str, float]:
        """The parameters' names and defaults."""
        return {i.name: i.default for i in self.inputs if i.own}

    def values(self, parameters: ParameterValues | None = None) -> list[Value]:
        """Return the inputs in order, each a number or (n,), from the scene's parameters.

        Parameters
        ----------
        parameters
            Names and values, a number or (n,) each; what is left out has its default.

        Raises
        ------
        TypeError
            If it is not a mapping.
        ValueError
            If a name is not one of the scene's.
        """
        if parameters is not None and not isinstance(parameters, Mapping):
            raise TypeError(
                f"parameters: expected a mapping of names to values, got {brief(parameters)}"
            )
        given = self.defaults | dict(parameters or {})
        strange = [name for name in given if name not in self.defaults]
        if strange:
            raise ValueError(f"parameters: {unknown(strange, tuple(self.defaults))}")
        numbers = {name: np.asarray(value, dtype=np.float64)[()] for name, value in given.items()}
        return [made.formula.evaluate(numbers) for made in self.inputs]

    def changes(self, parameters: ParameterValues, name: str) -> list[Value]:
        """Return the derivatives of the inputs by a parameter, in order.

        Parameters
        ----------
        parameters
            All parameters, a number or (n,) each.
        name
            The parameter.
        """
        numbers = {one: np.asarray(value, np.float64)[()] for one, value in parameters.items()}
        return [made.formula.derivative(numbers, name) for made in self.inputs]

    def derive(self) -> Derived:
        """Return the scene for derivation, in SymPy."""
        from .derivation import derivation_scene

        return derivation_scene(self.read, self.axes, self.remarks)

    def explain(self) -> str:
        """Return the derivation's page for the scene, in Markdown with LaTeX.

        Raises
        ------
        ImportError
            Without SymPy and Jinja2, which the extra `generate` brings.
        """
        try:
            from hoopgen.codegen.render import explanation

            from .derivation import derivation_scene
        except ImportError as error:
            from hoopgen.core.extras import explain_import_error

            raise explain_import_error(error, "Scene.explain") from None
        return explanation(derivation_scene(self._read(as_written=True), self.axes, self.remarks))
