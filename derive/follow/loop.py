"""Table 1, the event loop: what happens to a shot from its release to its end.

Four stages. `permit` looks at the parameters and `admit` at a release, once each; then `reach` finds
the next event and takes the ball there, and `meet` gives it its motion after that, again and again
until the shot has an outcome. Between the stages a target does what is its own: it fills its lanes,
writes the log, and stores results.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ..kernel import Kernel
from ..symbols import SPIN, VELOCITY
from .decisions import KERNELS
from .fields import CLAIMS, Field
from .tree import Do, Guard, Node, Repeat, check, needed, reads, walk, without

STEP_LIMIT = 201
"""Steps after which a search gives up and the shot is uncertain; a search takes about five."""

TEMPORARY_BOUNDS = {"late": 0.0, "delay": 0.0, "doubt": float("inf")}
"""What bounds errors within a stage, as it stands where no bounds are wanted."""

Parts = Mapping[str, Kernel]


@dataclass(frozen=True)
class Contact:
    """What the loop needs to know of a surface: its index, its kernels by part, its windows.

    Attributes
    ----------
    windows
        How many windows its search has; 0 if its only arrival is a closed form.
    """

    index: int
    parts: Parts
    windows: int


@dataclass(frozen=True)
class Loop:
    """The event loop of a scene.

    Attributes
    ----------
    fields
        What a shot has.
    job
        What is the same for all shots of a batch: numbers that the caller gives.
    stages
        The tree of each stage, by name, in order.
    """

    fields: tuple[Field, ...]
    job: tuple[str, ...]
    parameters: tuple[str, ...]
    stages: Mapping[str, tuple[Node, ...]]

    def __post_init__(self) -> None:
        known = {*self.job, *self.parameters, *(field.name for field in self.fields)}
        for nodes in self.stages.values():
            known = check(nodes, known)

    @property
    def called(self) -> frozenset[str]:
        """The names of the kernels that it evaluates."""
        nodes = (node for stage in self.stages.values() for node in walk(stage))
        return frozenset(node.kernel.name for node in nodes if isinstance(node, Do))

    def plain(self) -> Loop:
        """Return the loop without all that only bounds errors: the same path."""
        fixed = {f.name: f.start for f in self.fields if f.bounds and f.start is not None}
        fixed |= TEMPORARY_BOUNDS | {"position_error": 0.0, "velocity_error": 0.0, "claims": 0.0}
        kept = tuple(field for field in self.fields if not field.bounds)
        wanted = {field.name for field in kept}
        stages: dict[str, tuple[Node, ...]] = {}
        for name, nodes in reversed(self.stages.items()):
            stages[name] = needed(without(nodes, fixed), wanted)
            wanted |= reads(stages[name])
        stages = dict(reversed(stages.items()))
        return Loop(kept, tuple(j for j in self.job if j not in fixed), self.parameters, stages)


def event_loop(
    common: Parts,
    surfaces: Sequence[Contact],
    fields: Sequence[Field],
    parameters: Sequence[str],
) -> Loop:
    """Return the loop of a scene.

    Parameters
    ----------
    common
        The kernels of the scene and the decisions.
    surfaces
        In the order of their indices; the last one is the plane that ends a shot.
    """
    return Loop(
        tuple(fields),
        ("most_contacts", "claims"),
        tuple(parameters),
        {
            "permit": (Do(common["allowed"]), Do(common["finite_parameters"])),
            "admit": (Do(common["finite_state"]), Do(common["valid"]), Do(KERNELS["admitted"])),
            "reach": tuple(_reach(common, surfaces)),
            "meet": tuple(_meet(common, surfaces)),
        },
    )


def _reach(common: Parts, surfaces: Sequence[Contact]) -> Iterator[Node]:
    """Find the earliest arrival (Eq. 4) and take the ball there (Eq. 3)."""
    finish = surfaces[-1]
    yield Do(common["error_bounds"])
    yield Do(common["scale"])
    yield Do(KERNELS["opening"])
    # The end plane first: what certainly comes after it needs no further look.
    for surface in (finish, *surfaces[:-1]):
        if not surface.windows:
            yield from _plane_arrival(common, surface)
    for surface in surfaces:
        if surface.windows:
            yield from _curved_arrival(common, surface)
    yield Do(KERNELS["departed"], {"index": finish.index})
    yield Guard("moves", (Do(common["flight"], {"t": "when"}), Do(KERNELS["ticked"])))
    yield Do(common["displacement"], {"horizon": "when", "delay": "late"}, {"margin": "slack"})
    yield Do(common["target"], {}, {"target": "miss"})
    yield Do(KERNELS["doubted"])
    yield Do(KERNELS["accounted"])


def _proposed(index: int) -> Iterator[Node]:
    """Take an arrival that is earlier than those found so far."""
    yield Do(KERNELS["tied"])
    yield Do(KERNELS["sooner"], {"index": index})


def _plane_arrival(common: Parts, surface: Contact) -> Iterator[Node]:
    """Propose the only arrival on a plane; a contact counts within its bounds (Eq. 2)."""
    parts = surface.parts
    yield Do(KERNELS["left"], {"index": surface.index})
    yield Do(parts["arrival"])
    yield Do(KERNELS["meeting_plane"])
    yield Do(parts["margin"], {"horizon": "time"})
    yield Do(common["crossing"], {"rate_margin": 0.0})
    yield Do(KERNELS["timely"])
    yield Do(parts["margin"], {"horizon": "apex"})
    yield Do(KERNELS["grazed"])
    if "bounds" not in parts:
        yield Guard(
            "possible",
            (Do(KERNELS["crossed"]), *_proposed(surface.index)),
        )
        return
    there = {name: f"there_{name}" for name in ("x", "y", "z")}
    yield Guard(
        "possible",
        (
            Do(common["flight"], {"t": "time"}, there, frozenset(there)),
            Do(parts["bounds"], {k: v for k, v in there.items() if _takes(parts["bounds"], k)}),
            Do(common["displacement"], {"horizon": "time"}, {"margin": "slack"}),
            Do(parts["edges"]),
            Do(KERNELS["questioned"]),
            Do(parts["within"]),
            *_proposed(surface.index),
        ),
    )


def _takes(kernel: Kernel, name: str) -> bool:
    return any(argument.name == name for argument in kernel.arguments)


def _curved_arrival(common: Parts, surface: Contact) -> Iterator[Node]:
    """Propose the first arrival on a curved surface, searched from the left."""
    parts, index = surface.parts, {"index": surface.index}
    levels = {"position_error": "level", "velocity_error": "velocity_level"}
    rename = {"margin": "flat", "leaving_margin": "tilt", "rate_margin": "rate_slack"}
    own = {"margin": "flat", "leaving_margin": "tilt"}

    def allow() -> Iterator[Node]:
        """Allow for errors that are a share of the flight."""
        yield Do(common["allowance"], {"horizon": "latest"})
        given = {k: v for k, v in levels.items() if _takes(parts["margins"], k)}
        yield Do(parts["margins"], {"horizon": "latest", **given}, rename)

    def some(kernel: Kernel, **inputs: str) -> Do:
        return Do(kernel, {k: v for k, v in inputs.items() if _takes(kernel, k)})

    yield Do(common["horizon"], {"t": "when"}, {"horizon": "until"})
    yield some(parts["clear"], horizon="until")
    yield Do(KERNELS["opens"])
    yield Guard(
        "open",
        (
            some(parts["prepare"], horizon="until"),
            Do(KERNELS["beginning"]),
            *allow(),
            Do(KERNELS["beyond"]),
            Do(parts["enter"], {"after": 0.0, "t": 0.0, "end": 0.0}),
            Repeat(
                "searching",
                STEP_LIMIT,
                (
                    Do(KERNELS["nearby"], index),
                    some(parts["advance"], rate_margin="rate_slack"),
                    Do(KERNELS["struck"], {"rate_margin": "rate_slack"}),
                    Guard("vague", (Do(KERNELS["finer"]), *allow(), Do(KERNELS["exceeded"]))),
                    Do(KERNELS["advanced"]),
                    Guard("exhausted", (Do(parts["enter"], {"after": "end"}),)),
                ),
            ),
            Do(KERNELS["questioned"], {"unsure": "searching", "time": "t"}),
            Do(KERNELS["found"]),
            Do(KERNELS["nearby"], {**index, "t": "arrival"}),
            *(
                Do(parts["refine"], {"t": "arrival"}, {"time": "refined"}),
                Do(KERNELS["polished"]),
            )
            * 2,
            Do(parts["margins"], {"horizon": "latest"}, own),
            Do(KERNELS["own_margin"]),
            Do(common["crossing"]),
            Do(KERNELS["landed"]),
            Do(KERNELS["landed_surely"]),
            *_proposed(surface.index),
        ),
    )


def _meet(common: Parts, surfaces: Sequence[Contact]) -> Iterator[Node]:
    """Give the ball its motion after the contact (Eqs. 7-17), and its errors theirs."""
    yield Do(KERNELS["meeting"])
    yield Guard("meeting", tuple(_contact(common, surfaces)))
    yield Do(KERNELS["closing"])
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    claims = dict(zip(names, CLAIMS, strict=True))
    yield Guard("closed", (Do(common["claimed_errors"], {}, claims),))


def _contact(common: Parts, surfaces: Sequence[Contact]) -> Iterator[Node]:
    contacts = surfaces[:-1]

    def on(make: Callable[[Contact], Sequence[Node]], *, curved: bool | None = None) -> Iterator[Node]:
        """Do something of the surface that the ball is on."""
        for surface in contacts:
            if curved is None or bool(surface.windows) == curved:
                yield Do(KERNELS["here"], {"index": surface.index})
                yield Guard("here", tuple(make(surface)))

    yield Do(surfaces[-1].parts["normal"])
    yield from on(
        lambda s: (
            Do(s.parts["normal"]),
            Do(
                KERNELS["counted"],
                {"count": f"count_{s.index}"},
                {"count": f"count_{s.index}"},
            ),
        )
    )
    yield Do(KERNELS["elsewhere"])
    for surface in contacts:
        yield Do(KERNELS["again"], {"index": surface.index})
        yield Guard("again", (Do(surface.parts["curvature"], {}, {"curvature": "curving"}),))
    yield Do(common["carry_flight"], {"t": "when"})
    yield Do(KERNELS["delayed"])
    yield Guard("ends", (Do(KERNELS["floored"]),))
    yield Do(KERNELS["unturned"])
    yield from on(lambda s: (Do(s.parts["carry_normal"]),), curved=True)
    motion = {s.name: s.name for s in (*VELOCITY, *SPIN)}
    yield Guard("touches", (Do(common["carry_impact"]), Do(common["impact"], {}, motion)))
    yield from on(lambda s: (Do(s.parts["place"]),), curved=False)
    yield Guard("touches", (Do(KERNELS["touched"]),))
