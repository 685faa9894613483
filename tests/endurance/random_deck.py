# SPDX-License-Identifier: BSD-3-Clause
"""A random deck that is in order, and what is known of its run beforehand. The same seed and number make the same deck."""
import dataclasses
import random

from random_body import phantom
from random_materials import WITHOUT_ENERGY_OF_VOLUME, material, three_digits
from random_rig import forces, load_curves, rig

SHAPES = ["Linear", "GIMP", "CPDI", "Quadratic B-Spline", "Cubic B-Spline"]
PRECONDITIONERS = ["Geometric Multigrid", "Multigrid", "Jacobi", "Chebyshev", "Direct"]


@dataclasses.dataclass
class Deck:
    tree: dict                       # the deck itself
    traits: dict                     # kind of trait -> the deck's words, for the tally
    ranks: tuple                     # numbers of ranks to run it on
    image: bytes = b""               # body.nrrd, where the deck reads one
    box: tuple = (1.0, 1.0, 1.0)     # edges of the body's box [um]
    moves: dict = dataclasses.field(default_factory=dict)   # condition -> displacement at full load, the same at all its nodes
    is_elastic: bool = True          # the reactions are the derivative of strain_energy by the displacements of the conditions
    returns: bool = False            # loads go back to zero

    @property
    def is_plane(self):
        return self.tree["Grid"].get("Plane Strain", False)

    @property
    def has_holes(self):
        return any(shape["Label"] == -1 for shape in self.tree["Image"].get("Phantom", {}).get("Shapes", {}).values())


def grid(r, size, is_plane, is_plain, materials):
    """Elements of one to four voxels along an edge, in any ratio; with reset enough of them for two grips to share no node."""
    section = {"Reset": r.random() < (0.1 if is_plain else 0.5), "Shape Functions": r.choice(SHAPES)}
    least = 3  # four ranks take boxes of elements
    if section["Reset"]:
        least = 7 if "B-Spline" in section["Shape Functions"] else 5
    most = 3 if section["Shape Functions"] == "Cubic B-Spline" else 2  # what wide functions cost
    elements = [r.randint(max(least, n // 4), max(least, n // most)) for n in size]
    section["Elements"] = elements[:2] + [1] if is_plane else elements
    if is_plane:
        section["Plane Strain"] = True
    if section["Reset"] and section["Shape Functions"] != "Linear":
        section["Particle Domain"] = r.choice(["Stretched", "Stretched", "Undeformed"])
    can_average = "B-Spline" not in section["Shape Functions"] and all(
        numbers["Model"] not in WITHOUT_ENERGY_OF_VOLUME
        and numbers.get("Viscosity", {}).get("Applies To", "All" if "Viscosity" in numbers else "") != "All"
        for numbers in materials.values())
    section["Dilatation"] = r.choice(["Automatic", "Pointwise"] + ["Element Mean"] * can_average)
    return section


def fields(r, materials):
    """A modulus of the vessel that follows the image."""
    vessel = materials["vessel"]
    moduli = [name for name in vessel if name in ("Shear Modulus [Pa]", "C1 [Pa]")]
    if moduli and r.random() < 0.6:
        value = vessel[moduli[0]]
        vessel["Fields"] = {"density": {"Parameter": moduli[0], "Intensities": [100, 255],
                                        "Values": [value, three_digits(3 * value)]}}


def follow(curve, materials, conditions, loads):
    """All that changes in a run follows one curve."""
    drives = [numbers[kind] for numbers in materials.values() for kind in ("Active Stress", "Growth") if kind in numbers]
    for item in [*conditions.values(), *loads.values(), *drives]:
        item["Load Curve"] = curve


def steps(r, is_plain, curve):
    count = 4 if is_plain else r.randint(1, 4)
    return max(count, 2) if curve == "there and back" else count  # one step would be there and back at once


def traits_of(tree, rig_word, ranks):
    materials = tree["Materials"].values()
    families = [family for numbers in materials for family in numbers.get("Fibers", {}).values()]
    return {"shape": [tree["Grid"]["Shape Functions"]],
            "law": [numbers["Model"] for numbers in materials],
            "fibres": [family.get("Law", "of the law") for family in families],
            "beside": [kind for kind in ("Viscosity", "Active Stress", "Growth", "Fields") if any(kind in m for m in materials)],
            "rig": [rig_word],
            "reset": ["reset" if tree["Grid"]["Reset"] else "no reset"],
            "preconditioner": [tree["Solver"]["Preconditioner"]],
            "layout": [tree["Particles"]["Layout"]],
            "ranks": [str(n) for n in ranks],
            "space": ["plane strain" if tree["Grid"].get("Plane Strain") else "space"]}


def random_deck(seed, number):
    r = random.Random(f"{seed}.{number}")
    is_plain = r.random() < 0.4  # an elastic body, moved by its supports, whose work is the energy it gains
    is_plane = r.random() < 0.15
    size = [2 * r.randint(4, 7), 2 * r.randint(4, 7), 1 if is_plane else 2 * r.randint(4, 6)]
    voxel = [three_digits(r.uniform(0.5, 2)) for _ in range(3)]
    edges = [n * h for n, h in zip(size, voxel)]
    image, labels, file = phantom(r, size, voxel, is_plane)
    made = {name: material(r, label, is_plain) for label, name in enumerate(["gel", "vessel"][:labels])}
    materials = {name: numbers for name, (numbers, _) in made.items()}
    if file:
        fields(r, materials)
    section = grid(r, size, is_plane, is_plain, materials)
    conditions, moves, rig_word = rig(r, edges, is_plane, is_plain, section["Reset"])
    has_springs = not is_plain and rig_word != "loads" and r.random() < 0.25
    if section["Reset"] and "B-Spline" in section["Shape Functions"]:
        has_springs = False  # thousands of linear iterations a step (docs/theory.md, section 8)
    if has_springs:
        for condition in conditions.values():
            condition["Imposed By"] = "Penalty"
    has_loads = rig_word == "loads" or (not is_plain and rig_word in ("grips", "twist", "shear") and r.random() < 0.3)
    loads = forces(r, edges, conditions, is_plane) if has_loads else {}
    seconds = three_digits(10 ** r.uniform(-1, 3))
    curve = r.choice([None, None, None, "there and back", "early"])
    if curve:
        follow(curve, materials, conditions, loads)
    # Gauss points leave gaps between the domains of functions that average over them.
    layout = r.choice(["Voxel Centers"] * 3 + ["Per Element"] + ["Gauss"] * (section["Shape Functions"] == "Linear"))
    solver = {"Newton Tolerance": r.choice(["1e-8", "1e-10"]), "Preconditioner": r.choice(PRECONDITIONERS)}
    if r.random() < 0.3:
        solver["Forcing"] = "Constant"
    tree = {"Title": f"Endurance {seed}.{number}", "Image": image, "Materials": materials, "Particles": {"Layout": layout},
            "Grid": section, "Boundary Conditions": conditions, "External Forces": loads, "Load Curves": load_curves(r, seconds),
            "Loading": {"Duration [s]": seconds, "Steps": steps(r, is_plain, curve)}, "Solver": solver,
            "Output": {"Pictures": False, "Particles Every": r.choice([0, 0, 1]), "Grid Every": r.choice([0, 0, 1])}}
    ranks = r.choice([(1, 2), (1, 3), (1, 4), (2, 3), (2, 4)])
    is_elastic = (all(elastic for _, elastic in made.values()) and bool(moves)
                  and not (section["Reset"] or has_loads or has_springs))
    return Deck(tree, traits_of(tree, rig_word, ranks), ranks, file, tuple(edges), moves, is_elastic, curve == "there and back")


def yaml(tree, indent=""):
    """Nested lists as YAML."""
    lines = []
    for name, value in tree.items():
        if isinstance(value, dict):
            if value:
                lines += [f"{indent}{name}:", yaml(value, indent + "  ")]
        else:
            word = str(value).lower() if isinstance(value, bool) else value
            lines.append(f"{indent}{name}: {word}")
    return "\n".join(lines)
