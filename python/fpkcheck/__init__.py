"""Stationary densities of randomly excited oscillators with impacts, cross-checked.

    y'' + c y' + k y + mu y^3 = sum_k Y_k delta(t - tau_k)   for y > 0,     y'(+) = -r y'(-)  at y = 0

>>> import fpkcheck as fpk
>>> run = fpk.solve("case1", "epc-gaussian-n6,fd-kf", restitution=0.9)
>>> run.solutions["fd-kf"].status
'ok'
>>> run.l1("epc-gaussian-n6", "fd-kf")
{'y': ..., 'ydot': ...}

`Problem` is an oscillator with its excitation. `solve` solves problems with methods of the program and compares the
solutions. `Run` is the result. `load` reads a result from a directory that `fpkcheck run --out` or `Run.save` wrote.
`Density`, `Samples` and `File` add external densities to the comparison. `passage`, `spectrum`, `sensitivity` and
`densities_over_time` compute further quantities of a case. Arrays require NumPy only; tables with named axes require
xarray.

Invalid input raises ValueError with a message of one line. The failure to write a file raises RuntimeError. Ctrl-C
raises KeyboardInterrupt within about half a second.
"""

import atexit as _atexit

from . import _fpkcheck
from ._external import Density, File, Samples
from ._functionals import (
    DensitiesOverTime,
    FirstPassage,
    MarginalDerivatives,
    MethodResults,
    Sensitivities,
    Spectrum,
    densities_over_time,
    passage,
    sensitivity,
    spectrum,
)
from ._problem import Problem, load_case
from ._run import Case, Curve, Run, Solution, StatedError, load
from ._solve import methods, options, solve

__version__: str = _fpkcheck.__version__
__all__ = [
    "Case",
    "Curve",
    "DensitiesOverTime",
    "Density",
    "File",
    "FirstPassage",
    "MarginalDerivatives",
    "MethodResults",
    "Problem",
    "Run",
    "Samples",
    "Sensitivities",
    "Solution",
    "Spectrum",
    "StatedError",
    "densities_over_time",
    "load",
    "load_case",
    "methods",
    "options",
    "passage",
    "sensitivity",
    "solve",
    "spectrum",
]

# After Ctrl-C, abandoned threads may still run at the end of Python; the data that they use must not be destroyed.
_atexit.register(_fpkcheck.prepare_for_exit)
