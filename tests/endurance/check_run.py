# SPDX-License-Identifier: BSD-3-Clause
"""What must hold of a run, whatever its deck: history.csv against mechanics and against the run on other ranks.

Each check returns shares: how much of its tolerance was used. One above 1 is a fault.
"""
import csv
import math

NOT_RESULTS = ("newton_iterations", "linear_iterations", "residual", "wall_seconds")


def read_history(path):
    """column -> numbers
    \\raises ValueError where the file is not whole"""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    if len(rows) < 2 or any(len(row) != len(rows[0]) for row in rows):
        raise ValueError("history.csv is not whole")
    columns = {name: [float(row[n]) for row in rows[1:]] for n, name in enumerate(rows[0])}
    bad = [name for name, values in columns.items() if not all(map(math.isfinite, values))]
    if bad:
        raise ValueError(f"history.csv: {bad[0]} is not finite")
    return columns


def step_ends(deck, history):
    """Rows at load 0 and at the ends of the deck's steps; halved steps have others between.
    \\raises ValueError where one is missing"""
    steps = deck.tree["Loading"]["Steps"]
    rows = []
    for step in range(steps + 1):
        near = [n for n, load in enumerate(history["load"]) if abs(load - step / steps) < 1e-12]
        if len(near) != 1:
            raise ValueError(f"history.csv has {len(near)} rows at load {step / steps:g}")
        rows.append(near[0])
    if rows[-1] != len(history["load"]) - 1:
        raise ValueError("history.csv goes on beyond load 1")
    return rows


def factor(deck, item, time):
    """By what the full value of a condition or force is multiplied."""
    seconds = deck.tree["Loading"]["Duration [s]"]
    if "Load Curve" not in item:
        return time / seconds
    curve = deck.tree["Load Curves"][item["Load Curve"]]
    times, values = curve["Times [s]"], curve["Values"]
    n = 0 if time < times[1] else 1
    share = min(1.0, (time - times[n]) / (times[n + 1] - times[n]))
    if curve.get("Interpolation") == "Smooth":
        share *= share * (3 - 2 * share)
    return values[n] + share * (values[n + 1] - values[n])


def reaction(history, condition, row):
    return [history[f"{condition}.reaction_{axis}"][row] for axis in "xyz"]


def force_scale(deck, history):
    """The largest force that a support or a section of the body bears [pN]: what forces that vanish are compared to. Supports
    that bear a stress which has no resultant show in the stress alone."""
    conditions = deck.tree["Boundary Conditions"]
    rows = range(len(history["step"]))
    of_supports = max(abs(f) for name in conditions for row in rows for f in reaction(history, name, row))
    stress = max(max(history[f"{name}.von_mises_max"]) for name in deck.tree["Materials"])
    a, b, c = deck.box
    return max(of_supports, stress * max(a * b, b * c, a * c), 1e-300)


def nodes(deck):
    wide = {"Quadratic B-Spline": 2, "Cubic B-Spline": 3}.get(deck.tree["Grid"]["Shape Functions"], 1)
    return math.prod(n + wide for n in deck.tree["Grid"]["Elements"])


def convergence(deck, history, log):
    """The residual of each row against Newton's tolerance; where rounding limits it, against 1e-4 as the program has it."""
    tolerance = float(deck.tree["Solver"]["Newton Tolerance"])
    if "rounding limits the residual" in log:
        tolerance = 1e-4
    return max(history["residual"]) / tolerance


def applied_force(deck, history, row):
    """Resultant of the external forces [pN]; None where the deck alone does not tell it."""
    total, time = [0.0] * 3, history["time"][row]
    materials = deck.tree["Materials"]
    for force in deck.tree["External Forces"].values():
        if "Traction [Pa]" in force:
            if deck.has_holes:  # they may open into the face
                return None
            axis = "xyz".index(force["Face"][0])
            density, size = force["Traction [Pa]"], math.prod(edge for a, edge in enumerate(deck.box) if a != axis)
        elif "Body Force [pN/um^3]" in force:
            density, size = force["Body Force [pN/um^3]"], sum(history[f"{name}.volume"][0] for name in materials)
        else:  # 1 kg/m^3 m/s^2 is 1e-6 pN/um^3
            density = force["Acceleration [m/s^2]"]
            size = sum(1e-6 * materials[name]["Density [kg/m^3]"] * history[f"{name}.volume"][0] for name in materials)
        share = factor(deck, force, time)
        total = [t + share * size * d for t, d in zip(total, density)]
    return total


def equilibrium(deck, history):
    """Reactions and external forces sum to what Newton left: at most sqrt(nodes) times its norm (Cauchy-Schwarz). The norm is
    relative to the largest norm of the nodal forces, which the history does not tell: force_scale() stands for it. In plane strain
    what keeps u_z = 0 is no condition and shows nowhere."""
    worst, scale = 0.0, force_scale(deck, history)
    for row in range(len(history["step"])):
        applied = applied_force(deck, history, row)
        if applied is None:
            return 0.0
        left = max(history["residual"][:row + 1])
        allowed = scale * (math.sqrt(nodes(deck)) * left + 1e-12)
        for axis in range(2 if deck.is_plane else 3):
            total = applied[axis] + sum(reaction(history, name, row)[axis] for name in deck.tree["Boundary Conditions"])
            worst = max(worst, abs(total) / allowed)
    return worst


def energy_sign(history):
    largest = max(map(abs, history["strain_energy"]))
    return -min(history["strain_energy"]) / (1e-9 * largest + 1e-300)


def energy_balance(deck, history, stabilization):
    """Of an elastic body that is moved by its conditions alone, the energy gained over each two steps against the work of the
    reactions; None where the deck has no two equal steps.

    Work is integrated by Simpson's rule S. The trapezoidal rule T errs by about T - S, of the second order in the step; Simpson's
    of the fourth, for which a tenth of |T - S| is allowed. Fibres that slacken or straighten leave a kink in the force: a hinge
    within two steps costs Simpson's rule up to 2 |T - S|, and |T - S| may vanish by chance, so that twice its sum is allowed. To
    this comes what Newton leaves in the reactions, 1e-6, and what stabilization holds, which strain_energy leaves out.

    \param stabilization  the share of the energy that the log states"""
    rows, conditions, pairs = step_ends(deck, history), deck.tree["Boundary Conditions"], []
    for first, middle, last in zip(rows[:-2:2], rows[1:-1:2], rows[2::2]):
        simpson = trapezoids = 0.0
        for name, full in deck.moves.items():
            a, b, c = (factor(deck, conditions[name], history["time"][row]) for row in (first, middle, last))
            if abs((b - a) - (c - b)) > 1e-9:
                return None
            power = [sum(r * u for r, u in zip(reaction(history, name, row), full)) for row in (first, middle, last)]
            simpson += (c - a) / 6 * (power[0] + 4 * power[1] + power[2])
            trapezoids += (c - a) / 4 * (power[0] + 2 * power[1] + power[2])
        pairs.append((history["strain_energy"][last] - history["strain_energy"][first] - simpson, abs(trapezoids - simpson)))
    if not pairs:
        return None
    floor = max(history["strain_energy"]) * (1e-6 + 2 * stabilization) + 1e-300
    if any("Fibers" in numbers for numbers in deck.tree["Materials"].values()):
        allowed = 2 * sum(estimate for _, estimate in pairs) + floor
        return max(abs(off) / allowed for off, _ in pairs)
    return max(abs(off) / (0.1 * estimate + floor) for off, estimate in pairs)


def return_to_rest(deck, history):
    """An elastic body whose supports are back where they were bears nothing: forces to 1e-6 of the largest, energy to 1e-9."""
    scale, energy = force_scale(deck, history), max(history["strain_energy"]) + 1e-300
    left = max(abs(f) for name in deck.tree["Boundary Conditions"] for f in reaction(history, name, -1))
    return max(left / (1e-6 * scale), abs(history["strain_energy"][-1]) / (1e-9 * energy))


def same_on_other_ranks(deck, one, other):
    """Results at the ends of the deck's steps, by the largest value of their kind. Both runs are within Newton's tolerance of
    the answer, each on its side, and so have to be their figures: 1e-8 by default."""
    if list(one) != list(other):
        return math.inf, "columns"
    allowed = float(deck.tree["Solver"]["Newton Tolerance"])
    pairs = list(zip(step_ends(deck, one), step_ends(deck, other)))
    force = force_scale(deck, one)
    worst, where = 0.0, ""
    for name in one:
        if name in NOT_RESULTS or name == "step":
            continue
        scale = force if "reaction" in name else max(map(abs, one[name])) or 1.0
        found = max(abs(one[name][a] - other[name][b]) for a, b in pairs) / scale / allowed
        if found > worst:
            worst, where = found, name
    return worst, where
