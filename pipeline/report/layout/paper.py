"""The printed numbers of the paper: Tables I and II of Liu et al., and their layout."""

STROKES = (1, 5, 9)
METRICS = ("average", "maximum", "rmse")
TITLES = {1: "FORWARD KINEMATICS MODEL ERROR COMPARISON", 2: "INVERSE KINEMATICS MODEL ERROR COMPARISON"}
MAPS = {1: "forward", 2: "inverse"}
UNITS = {1: "mm", 2: "θ/2π"}

# number of the table → model → stroke → average, maximum, RMSE
TABLES = {
    1: {
        "inn": {1: (0.180, 0.551, 0.222), 5: (0.219, 0.544, 0.269), 9: (0.259, 0.566, 0.311)},
        "traditional": {1: (1.103, 4.382, 1.766), 5: (1.749, 4.813, 2.094), 9: (2.101, 4.920, 2.390)},
    },
    2: {
        "inn": {1: (0.584, 1.681, 0.721), 5: (0.819, 2.234, 1.061), 9: (0.870, 2.324, 1.112)},
        "traditional": {1: (1.351, 3.861, 1.811), 5: (2.871, 6.013, 3.140), 9: (3.239, 6.945, 3.470)},
    },
}


def header(number: int) -> list[str]:
    """Column heads of Table I or II; they never change, since programs read the csv by them."""
    unit = UNITS[number]
    return ["Model", "Stroke times", f"Average error ({unit})", f"Maximum error ({unit})", f"RMSE ({unit})"]
