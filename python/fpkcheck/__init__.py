"""Stationary densities of randomly excited oscillators with impacts, cross-checked.

    y'' + c y' + k y + mu y^3 = sum_k Y_k delta(t - tau_k)   for y > 0,     y'(+) = -r y'(-)  at y = 0

>>> import fpkcheck as fpk
>>> run = fpk.solve("case1", "epc-gaussian-n6,fd-kf", restitution=0.9)
>>> run.solutions["fd-kf"].status
'ok'
>>> run.l1("epc-gaussian-n6", "fd-kf")
{'y': ..., 'ydot': ...}

`Problem` says what is solved, `solve` solves it by any methods of the program and compares, `Run` is what came
out, `load` reads what `fpkcheck run` or `Run.save` left in a directory. `Density`, `Samples` and `File` bring a
density of one's own into the comparison. What NumPy can hold needs NumPy alone; tables with named axes need xarray.

Input that cannot be used raises ValueError, in the one line that the program says; a file that cannot be written,
RuntimeError. Ctrl-C is answered within half a second or so, by KeyboardInterrupt.
"""

import atexit as _atexit

from . import _fpkcheck
from ._own import Density, File, Samples
from ._problem import Problem, load_case
from ._run import Case, Curve, Run, Solution, StatedError, load
from ._solve import methods, options, solve

__version__: str = _fpkcheck.__version__
__all__ = [
    "Case",
    "Curve",
    "Density",
    "File",
    "Problem",
    "Run",
    "Samples",
    "Solution",
    "StatedError",
    "load",
    "load_case",
    "methods",
    "options",
    "solve",
]

# Threads that Ctrl-C left behind must not outlive what they stand on.
_atexit.register(_fpkcheck.prepare_for_exit)
