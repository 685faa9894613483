# SPDX-License-Identifier: BSD-3-Clause
"""How a random body is held and loaded: conditions, forces, and the load curves that they may follow."""
from random_materials import three_digits

AXES = "xyz"


def rig(r, edges, is_plane, is_plain, has_reset):
    """(conditions, the displacement of each that moves as a whole, word for the tally)"""
    kind = r.choice(["grips", "rollers", "confined", "shear"] + ["twist", "gradient", "loads", "loads"] * (not is_plain))
    strain = three_digits(r.choice([-1, 1, 1]) * r.uniform(0.01, 0.08 if has_reset else 0.12))
    axis = r.choice([0, 1]) if is_plane else r.randrange(3)
    name, other = AXES[axis], (axis + 1) % (2 if is_plane else 3)
    lower, upper = {"Face": name + "-", "Components": "xyz"}, {"Face": name + "+", "Components": "xyz"}
    stretch = [strain * edges[axis] if a == axis else 0.0 for a in range(3)]
    if kind == "loads":
        return {"lower": lower}, {"lower": [0.0] * 3}, kind
    if kind == "grips":
        upper["Strain"] = strain
        if r.random() < 0.3:  # both move
            lower["Strain"] = three_digits(strain / 2)
            opposite = [-lower["Strain"] * edges[axis] if a == axis else 0.0 for a in range(3)]
            return {"lower": lower, "upper": upper}, {"lower": opposite, "upper": stretch}, kind
        return {"lower": lower, "upper": upper}, {"lower": [0.0] * 3, "upper": stretch}, kind
    if kind == "shear":
        shift = [three_digits(abs(strain) * edges[axis]) if a == other else 0.0 for a in range(3)]
        upper["Displacement [um]"] = shift
        return {"lower": lower, "upper": upper}, {"lower": [0.0] * 3, "upper": shift}, kind
    if kind == "twist":
        upper["Rotation [deg]"] = three_digits(r.uniform(2, 15))
        if is_plane:
            upper["Axis"] = [0, 0, 1]
        return {"lower": lower, "upper": upper}, {}, kind
    if kind == "gradient":
        rows = [three_digits(r.uniform(-0.05, 0.05)) for _ in range(9)]
        if is_plane:
            rows = [g if n in (0, 1, 3, 4) else 0.0 for n, g in enumerate(rows)]
        return {"sides": {"Face": "all", "Components": "xyz", "Displacement Gradient": rows}}, {}, kind
    # Rollers: symmetry planes, or only two opposite faces, whose free motions Stroma holds by itself. Confined: all sides.
    conditions = {"lower": {"Face": name + "-", "Components": name},
                  "upper": {"Face": name + "+", "Components": name, "Strain": strain}}
    for a in range(2 if is_plane else 3):
        if a != axis:
            for side in "-+" if kind == "confined" else r.choice(["", "-"]):
                conditions[AXES[a] + ("lower" if side == "-" else "upper")] = {"Face": AXES[a] + side, "Components": AXES[a]}
    moves = {condition: [0.0] * 3 for condition in conditions}
    moves["upper"] = stretch
    return conditions, moves, kind


def forces(r, edges, conditions, is_plane):
    """Dead loads that strain a body of 200 Pa by some percent, where it is held on its lower face."""
    face = conditions["lower"]["Face"].replace("-", "+")
    size = 200.0 * 0.06
    vector = [three_digits(r.uniform(-size, size)) for _ in range(3)]
    if is_plane:
        vector[2] = 0.0
    kinds = [{"Traction [Pa]": vector, "Face": face},
             {"Body Force [pN/um^3]": [three_digits(f / max(edges)) for f in vector]},
             {"Acceleration [m/s^2]": [three_digits(f / max(edges) * 1e3) for f in vector]}]
    return {f"force{n}": force for n, force in enumerate(r.sample(kinds, r.randint(1, 2)))}


def load_curves(r, seconds):
    times = [0.0, 0.5 * seconds, seconds]
    return {"there and back": {"Times [s]": times, "Values": [0, 1, 0], "Interpolation": r.choice(["Linear", "Smooth"])},
            "early": {"Times [s]": times, "Values": [0, three_digits(r.uniform(0.6, 1)), 1]}}
