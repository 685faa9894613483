# SPDX-License-Identifier: BSD-3-Clause
"""A random material: any matrix law, any fibres, viscosity, active stress, growth (docs/materials.md).

Moduli are some hundred Pa and exponents those of tissue, so that most bodies can bear what random_deck.py does to them.
"""


def three_digits(value):
    return float(f"{value:.3g}")


def direction(r):
    return [three_digits(r.uniform(-1, 1)) for _ in range(2)] + [three_digits(r.uniform(0.2, 1))]


def neo_hookean(r, mu):
    return {"Shear Modulus [Pa]": mu, "Volumetric Energy": r.choice(["Logarithmic", "Quadratic"])}


def coupled_neo_hookean(r, mu):
    return {"Shear Modulus [Pa]": mu}


def mooney_rivlin(r, mu):
    share = r.uniform(0, 0.4)
    return {"C1 [Pa]": three_digits(mu / 2 * (1 - share)), "C2 [Pa]": three_digits(mu / 2 * share)}


def ogden(r, mu):
    powers = r.choice([[2], [4], [-4], [8, 2], [-6, 3], [2, -2]])
    return {"C [Pa]": [three_digits(2 * mu / len(powers))] * len(powers), "M": powers}


def yeoh(r, mu):
    moduli = [three_digits(mu / 2), three_digits(mu * r.uniform(0, 0.5)), three_digits(mu * r.uniform(0, 0.2))]
    return {"C [Pa]": moduli[:r.randint(1, 3)]}


def veronda_westmann(r, mu):
    exponent = three_digits(r.uniform(0.5, 6))
    return {"C1 [Pa]": three_digits(mu / exponent), "C2": exponent}


def holmes_mow(r, mu):
    return {"Shear Modulus [Pa]": mu, "Beta": three_digits(r.uniform(0.1, 2))}


def arruda_boyce(r, mu):
    return {"Shear Modulus [Pa]": mu, "N": three_digits(r.uniform(2, 30))}


def artery(r, mu):
    return {"C [Pa]": [mu], "K1 [Pa]": three_digits(mu * r.uniform(0.5, 5)), "K2": three_digits(r.uniform(0.5, 20)),
            "Kappa": three_digits(r.uniform(0, 0.33))}


MODELS = {"Neo-Hookean": neo_hookean, "Coupled Neo-Hookean": coupled_neo_hookean, "Mooney-Rivlin": mooney_rivlin, "Ogden": ogden,
          "Yeoh": yeoh, "Veronda-Westmann": veronda_westmann, "Holmes-Mow": holmes_mow, "Arruda-Boyce": arruda_boyce,
          "Holzapfel-Gasser-Ogden": artery}
WITHOUT_ENERGY_OF_VOLUME = ("Coupled Neo-Hookean", "Holmes-Mow")


def exponential_power(r, mu):
    return {"Xi [Pa]": mu, "Alpha": r.choice([0, three_digits(r.uniform(0.1, 5))]), "Beta": three_digits(r.uniform(2, 3.5))}


def exponential_linear(r, mu):
    return {"C3 [Pa]": three_digits(mu / 10), "C4": three_digits(r.uniform(5, 20)), "C5 [Pa]": three_digits(mu * r.uniform(1, 5)),
            "Lambda Max": three_digits(r.uniform(1.01, 1.06))}


def buckling_stiffening(r, mu):
    return {"K [Pa]": mu, "D0": three_digits(r.uniform(0.005, 0.05)), "Lambda S": three_digits(r.uniform(0.02, 0.08)),
            "DS": three_digits(r.uniform(0.03, 0.06))}


FIBER_LAWS = {"Exponential-Power": exponential_power, "Exponential-Linear": exponential_linear,
              "Buckling-Stiffening": buckling_stiffening}


def family(r, mu):
    law = r.choice(list(FIBER_LAWS))
    numbers = {"Law": law, **FIBER_LAWS[law](r, three_digits(mu * r.uniform(0.2, 1.5)))}
    distribution = r.choice(["Single", "Single", "Spherical", "Ellipsoidal", "Axial"])
    numbers["Distribution"] = distribution
    if distribution in ("Single", "Axial"):
        numbers["Direction"] = direction(r)
    if distribution == "Axial":
        numbers["Concentration"] = three_digits(r.uniform(-2, 3))
    if distribution == "Ellipsoidal":
        numbers["Axes"] = [three_digits(r.uniform(0.4, 1.5)) for _ in range(3)]
    if distribution != "Single":
        numbers["Quadrature"] = r.randint(2, 4)  # about 3 n^2 directions a particle, which is what such a run costs
    return numbers


def drive_direction(r, kind, plain_kind):
    return {"Kind": kind} if kind == plain_kind else {"Kind": kind, "Direction": direction(r)}


def material(r, label, is_plain):
    """(parameters, whether its stress is the derivative of its strain_energy). A plain one is elastic."""
    mu = three_digits(200 * 5 ** r.uniform(0, 1))
    model = r.choice(list(MODELS))
    # Holmes-Mow softens above 1/3 (docs/materials.md).
    nu = three_digits(r.uniform(0.1, 0.33 if model == "Holmes-Mow" else 0.47))
    numbers = {"Label": label, "Model": model, **MODELS[model](r, mu), "Poisson Ratio": nu,
               "Density [kg/m^3]": three_digits(r.uniform(900, 1200))}
    if model == "Holzapfel-Gasser-Ogden":
        numbers["Fibers"] = {f"family{n}": {"Direction": direction(r)} for n in range(r.randint(1, 2))}
    elif r.random() < 0.4:
        numbers["Fibers"] = {f"family{n}": family(r, mu) for n in range(r.randint(1, 2))}
    if is_plain:
        return numbers, True
    is_elastic = True
    if r.random() < 0.2:
        terms = r.randint(1, 3)
        numbers["Viscosity"] = {"Moduli": [three_digits(r.uniform(0.1, 0.8)) for _ in range(terms)],
                                "Relaxation Times [s]": [three_digits(10 ** r.uniform(-1, 2)) for _ in range(terms)]}
        if model not in WITHOUT_ENERGY_OF_VOLUME and "Fibers" not in numbers and r.random() < 0.4:
            numbers["Viscosity"]["Applies To"] = "Deviatoric"
        is_elastic = False
    if r.random() < 0.15:
        numbers["Active Stress"] = {"T0 [Pa]": three_digits(mu * r.uniform(-0.05, 0.15)),
                                    **drive_direction(r, r.choice(["Isotropic", "Fiber", "Transverse"]), "Isotropic")}
        is_elastic = False
    if r.random() < 0.1:
        numbers["Growth"] = {"Ratio": three_digits(r.uniform(0.93, 1.1)),
                             **drive_direction(r, r.choice(["Volume", "Fiber", "Area"]), "Volume")}
        is_elastic = False
    return numbers, is_elastic
