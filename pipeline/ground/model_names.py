"""The names of models that pages and programs treat specially."""

PAPER = "inn"  # the paper's own, held against each of the others
NOMINAL = "traditional"  # the paper's equations, which learn nothing: last in every table
USUAL = "spline"  # the one to take where nobody says which and errors are much alike: docs/models.md says why
EQUATIONS = "calibrated"  # the equations with each string's own dimensions: the one to ask beyond recorded loads
SIMULATOR = "diagnosed"  # the simulator with what a diagnosis names: its errors stand beside those of the one to take
FLOORS = ("floor_blind", "floor")  # beside the models in tables of errors: the least error that the data allow
