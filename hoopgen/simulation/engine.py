"""`Engine`: a scene that is ready to be simulated and proved."""

from __future__ import annotations

from typing import TYPE_CHECKING, Unpack

from numpy.typing import ArrayLike

from hoopgen.core.parameters import ParameterValues
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.results.shots import Shots

from .run import SimulationOptions, run

if TYPE_CHECKING:
    from hoopgen.judge import Certificate, CertificationOptions


class Engine(CompiledScene):
    """A scene, compiled: `hoopgen.compile` returns one, and `hoopgen.HOOP` is the article's.

    All else that it has is that of a `CompiledScene`.
    """

    def simulate(
        self,
        states: ArrayLike,
        parameters: ParameterValues | None = None,
        **options: Unpack[SimulationOptions],
    ) -> Shots:
        """Simulate shots in this scene.

        Parameters
        ----------
        states, parameters, options
            As for `hoopgen.simulate`, without the scene; so is what is returned and raised.
        """
        return run(self, states, parameters, **options)

    def certify(
        self,
        states: ArrayLike,
        parameters: ParameterValues | None = None,
        **options: Unpack[CertificationOptions],
    ) -> Certificate:
        """Prove what shots do in this scene.

        Parameters
        ----------
        states, parameters, options
            As for `hoopgen.certify`, without the scene; so is what is returned and raised.
        """
        from hoopgen import judge  # which needs SymPy and python-flint

        return judge.certify(states, parameters, scene=self, **options)
