"""Reference solutions of randomly excited oscillators with and without impacts: exact laws and computed values.

    import fpkcheck_reference as reference
    reference.problems()                                    # names
    duffing = reference.problem("duffing")
    duffing.equation, duffing.parameters, duffing.source    # LaTeX, keys of the case file, publication
    duffing.value("E[y^2]")                                 # value with its error and origin
    duffing.density("y")(0.5)                               # p(y)
    print(reference.score("duffing", {"y": my_density, "ydot": (points, values)}))

All quantities are non-dimensional; v is the velocity y'. docs/reference_data.md of fpkcheck describes the problems.
"""

from ._catalogue import problem, problems
from ._problem import Problem, Value
from ._score import Distance, MomentError, Score, score

__all__ = ["Distance", "MomentError", "Problem", "Score", "Value", "problem", "problems", "score"]
