"""The kernels of the contact laws; laws that differ by their parameters alone share them."""

from __future__ import annotations

from collections.abc import Sequence, Set

import sympy as sp

from ..contact.friction import CoulombFriction
from ..contact.law import Law
from ..contact.no_slip import NoSlip
from ..errors import contact_frames, friction, propagation, tighter_bounds
from ..ir.kernel import Kernel, kernel
from ..motion.parabola import Parabola
from ..rolling import friction_limit, jump, settling
from ..scenes.scene import Scene
from ..state import shared_kernels
from ..symbolic.isomorphism import Isomorphism
from ..symbolic.symbols import normal, spin, velocity
from .arguments import components
from .scene import MOTION
from .variation import law_variation


def law_kernels(
    scene: Scene, likes: Sequence[Isomorphism], order: tuple[sp.Symbol, ...]
) -> dict[Law, dict[str, Kernel]]:
    """Return the kernels of each law by part, given the law that each is isomorphic to.

    Parameters
    ----------
    scene
        The scene, with its laws in the order of its bodies.
    likes
        For each law the first law of the same form, and the symbols that take the place of its own.
    order
        The symbols in the order of arguments.

    Returns
    -------
    dict
        By law and part; isomorphic laws share their kernels.
    """
    found: dict[Law, dict[str, Kernel]] = {}
    for law, like in zip(scene.laws, likes, strict=True):
        first = scene.laws[like.first]
        if first in found:
            found[law] = found[first]
            continue
        own = {s for other in likes if other.first == like.first for s in other.symbols}
        found[law] = _kernels(law, scene, order, own)
    return found


def _kernels(
    law: Law, scene: Scene, order: tuple[sp.Symbol, ...], differing: Set[sp.Symbol]
) -> dict[str, Kernel]:
    """Return the kernels of one law; isomorphic laws differ by the parameters `differing`."""
    kernels = {}
    if differing:
        parameters = [symbol for symbol in scene.symbols if symbol in differing]
        kernels["taken"] = kernel(
            f"{law.name}_taken",
            shared_kernels.parameter_outputs(parameters),
            order,
            "The parameters in which one body's law differs from another's.",
            "data",
        )
    undecided = law.undecided(normal, velocity, spin, scene.ball)
    if undecided is not None and not scene.proves_errors:
        kernels["undecided"] = kernel(
            f"{law.name}_undecided",
            {"undecided": undecided},
            order,
            "Whether a decision within the contact lies within its error.",
            "the law's own slack",
        )
    if scene.rolls:
        kernels["settling"] = settling.settling(
            law, scene.ball, scene.flight, scene.rolls_about_axes
        )
        if scene.bounds_jumps:
            kernels["rebound"] = jump.rebound_kernel(law)
        kernels["grip_deficit"] = friction_limit.friction_excess(law)
    bounds = _bounds(law, scene, order)
    carried = bounds.pop("carry", None) or kernel(
        f"carry_{law.name}",
        propagation.errors_after_impact(law, scene.ball, scene.rolls),
        order,
        "Errors of velocity and spin after a contact, from those before it.",
        _carried_source(law),
        scene.single_errors,
    )
    return {
        **kernels,
        **bounds,
        "impact": kernel(
            law.name,
            components(MOTION, *law.after(normal, velocity, spin, scene.ball)),
            order,
            "Velocity and spin after a contact, frame-free.",
            law.source,
        ),
        "carry": carried,
        "vary": law_variation(law, scene, order),
    }


def _carried_source(law: Law) -> str:
    return f"derivative of {law.description}, with roundings"


def _bounds(law: Law, scene: Scene, order: tuple[sp.Symbol, ...]) -> dict[str, Kernel]:
    """Return the kernels that carry proved bounds over a contact, if a scene has some.

    They take the place of the vector of errors (`carry`), or stand beside it (`bound`).
    """
    if not isinstance(scene.flight, Parabola) or not (scene.proves_errors or scene.proves_bounces):
        return {}
    impact, source = _impact_errors(law, scene), _carried_source(law)
    kernels = {}
    if isinstance(law, CoulombFriction) and law.decides:
        kernels["slip"] = kernel(
            f"{law.name}_slip",
            friction.slip_outputs(law.slip(normal, velocity, spin, scene.ball)),
            order,
            "Slip of a contact, the share of it that friction takes, and the margin of grip.",
            law.source,
        )
    part = "carry" if scene.proves_errors else "bound"
    kernels[part] = kernel(
        f"{part}_{law.name}",
        contact_frames.contact_errors(scene.flight, impact),
        order,
        "Bounds on errors after a contact, from those at the departure before it.",
        source,
        True,
    )
    if scene.proves_errors:
        kernels["tighten"] = kernel(
            f"tighten_{law.name}",
            tighter_bounds.tighter_errors(scene.flight, impact),
            order,
            "The same, through the product of derivatives since an earlier contact.",
            source,
            True,
        )
    return kernels


def _impact_errors(law: Law, scene: Scene) -> contact_frames.Impact:
    """Return the errors that a law of a scene with proved bounds makes of errors."""
    if isinstance(law, NoSlip):
        return contact_frames.NoSlipImpact(scene.ball, law.restitution)
    if isinstance(law, CoulombFriction):
        return friction.FrictionImpact(scene.ball, law)
    raise TypeError(f"{law.name}: expected a law with proved bounds, got {type(law).__name__}")
