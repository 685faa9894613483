#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens a report in headless Chromium and holds what it shows against the files beside it. Prints what is wrong.

    browse.py run DIR [X Y Z VALUE]   of a run: VALUE is the von Mises stress of the last step at X, Y, Z [um]
    browse.py study DIR
    browse.py fit DIR
    browse.py stiffness DIR
    browse.py says DIR TEXT...        of any: what it says, and with ! before it what it does not
    browse.py layout DIR              of any: that it is drawn
"""
import contextlib
import csv
import itertools
import json
import math
import sys
import time
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

WRONG = []


def expect(holds, what):
    if not holds:
        WRONG.append(what)


def near(a, b, share):
    return abs(a - b) <= share * max(abs(a), abs(b), 1e-300)


@contextlib.contextmanager
def browser():
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    try:
        yield driver
    finally:
        driver.quit()


def until(holds, what, seconds=20):
    end = time.time() + seconds
    while time.time() < end:
        if holds():
            return
        time.sleep(0.02)
    expect(False, f"{what}, in {seconds} s")


def open_page(driver, page, width, scheme):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    driver.get(page.resolve().as_uri())
    until(lambda: driver.execute_script("return document.documentElement.hasAttribute('data-ready')"), "the page is not ready")


def check_layout(driver, page):
    """Nothing sticks out at either width, in light and dark; everything to use has a name."""
    for width in (1280, 400):
        for scheme in ("light", "dark"):
            open_page(driver, page, width, scheme)
            beyond = driver.execute_script("return document.documentElement.scrollWidth - window.innerWidth")
            expect(beyond <= 0, f"{beyond} pixels stick out at {width}, {scheme}")
            nameless = driver.execute_script("""return [...document.querySelectorAll("input, select, canvas, button, summary, section")].filter((e) =>
                !(e.getAttribute("aria-label") || e.getAttribute("aria-labelledby") || (e.labels && e.labels.length) || e.textContent)).map((e) => e.outerHTML)""")
            expect(not nameless, f"without a name: {nameless}")


def check_quiet(driver):
    """Nothing is fetched, and the console is empty."""
    for entry in driver.get_log("browser"):
        expect(False, f"console: {entry['message']}")
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            url = message["params"]["request"]["url"]
            expect(url.startswith("file:") and url.endswith("report.html") or url.startswith("data:"), f"fetched {url[:80]}")


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def numbers(rows, name):
    column = rows[0].index(name)
    return [float(row[column]) for row in rows[1:]]


def series(driver, chart):
    """[{label, data: [{x, y}]}] as Chart.js has it."""
    return driver.execute_script("""const chart = Chart.getChart(arguments[0]);
        return chart ? chart.data.datasets.map((one) => ({label: one.label, data: one.data})) : []""", chart)


def axis_title(driver, chart, axis):
    return driver.execute_script("return Chart.getChart(arguments[0]).options.scales[arguments[1]].title.text", chart, axis)


UNITS = {"pN": 1.0, "nN": 1e3, "µN": 1e6, "mN": 1e9, "aJ": 1.0, "fJ": 1e3, "pJ": 1e6, "nJ": 1e9, "pN µm": 1.0, "nN µm": 1e3, "µN µm": 1e6, "Pa": 1.0, "kPa": 1e3, "MPa": 1e6,
         "µs": 1e-6, "ms": 1e-3, "s": 1.0}


def unit_of(driver, chart, axis="y"):
    return UNITS[axis_title(driver, chart, axis).split("(")[1].rstrip(")")]


def expect_curve(curve, values, unit, what):
    """A curve's heights are these values."""
    expect(len(curve["data"]) == len(values) and all(near(point["y"] * unit, value, 1e-12) for point, value in zip(curve["data"], values)), f"{what} is not drawn")


def check_forces(driver, rows, data):
    """The force along the displacement of the first support that moves, or the components of all supports' forces."""
    curves, unit = series(driver, "force-chart"), unit_of(driver, "force-chart")
    if not data["supports"]:
        expect(curves != [], "there is no force of a support")
        for curve in curves:
            name, axis = curve["label"].rsplit(", ", 1)
            expect_curve(curve, numbers(rows, f"{name}.reaction_{axis}"), unit, f"the force of {curve['label']}")
        return
    support, curve = data["supports"][0], curves[0]
    expect(curve["label"] == support["name"], "the first curve is not that of the first support")
    axis = max(range(3), key=lambda d: abs(support["displacement"][d]))
    sign = 1.0 if support["displacement"][axis] > 0 else -1.0
    expect_curve(curve, [sign * f for f in numbers(rows, f"{support['name']}.reaction_{'xyz'[axis]}")], unit, f"the force of {support['name']}")
    seconds_in_unit = unit_of(driver, "force-chart", "x") if data["has_time"] else None
    for point, load, seconds in zip(curve["data"], numbers(rows, "load"), numbers(rows, "time")):
        x = seconds / seconds_in_unit if data["has_time"] else 100.0 * load * (support["strain"] or data["shears"][support["name"]])
        expect(near(point["x"], x, 1e-12), f"drawn at {point['x']} instead of {x}")


def check_curves_of_kinds(driver, rows, data):
    """Energies of a body in motion, torques of faces that turn, pressures and their volumes."""
    if "kinetic_energy" in rows[0]:
        curves, unit = {one["label"]: one for one in series(driver, "energy-chart")}, unit_of(driver, "energy-chart")
        for label, column in (("strain", "strain_energy"), ("kinetic", "kinetic_energy")):
            expect_curve(curves[label], numbers(rows, column), unit, f"the {label} energy")
    for turn, curve in zip(data["turning"], series(driver, "torque-chart")):
        expect_curve(curve, numbers(rows, f"{turn['name']}.torque"), unit_of(driver, "torque-chart"), f"the torque of {turn['name']}")
        expect(near(curve["data"][-1]["x"], turn["degrees"], 1e-12), "the torque is not drawn to the full angle")
    expect(len(series(driver, "torque-chart")) == len(data["turning"]), "a torque is not drawn")
    for name, curve in zip(data["pressures"], series(driver, "pressure-volume-chart")):
        volumes = numbers(rows, f"{name}.volume")
        expect_curve(curve, numbers(rows, f"{name}.pressure"), unit_of(driver, "pressure-volume-chart"), f"the pressure of {name}")
        expect(all(near(point["x"], volume / volumes[0], 1e-12) for point, volume in zip(curve["data"], volumes)), f"the volume of {name} is not drawn")
    expect(len(series(driver, "pressure-volume-chart")) == len(data["pressures"]), "a pressure is not drawn")


def check_scale_of_time(driver):
    """Where there is a choice, time may be logarithmic, and linear again."""
    for scale, kind in (("log", "logarithmic"), ("linear", "linear")):
        driver.execute_script("document.querySelector(`input[name=time-scale][value=${arguments[0]}]`).click()", scale)
        until(lambda kind=kind: driver.execute_script("return Chart.getChart('force-chart').options.scales.x.type") == kind, f"the scale of time is not {kind}")


def check_history(driver, folder):
    """The table is history.csv, and the curve is its reaction."""
    rows = rows_of(folder / "history.csv")
    details = driver.find_element(By.CSS_SELECTOR, "#force details")
    driver.execute_script("arguments[0].open = true", details)
    until(lambda: details.find_elements(By.TAG_NAME, "tbody"), "history.csv is not shown")
    shown = driver.execute_script("return [...arguments[0].querySelectorAll('tr')].map((row) => [...row.children].map((field) => field.textContent))", details)
    expect(shown == rows, "the table is not history.csv")

    data = driver.execute_script("return JSON.parse(document.getElementById('data').textContent)")
    check_forces(driver, rows, data)
    check_curves_of_kinds(driver, rows, data)
    if driver.find_elements(By.NAME, "time-scale"):
        check_scale_of_time(driver)
    steps = [round(one["step"]) for one in data["maps"]["steps"]]
    most = max(numbers(rows, f"{name}.von_mises_max")[step] for name in data["materials"] for step in steps)
    field = data["maps"]["fields"][0]
    if data["maps"]["merged"] == [1, 1, 1]:
        expect(field["low"] == 0.0 and near(field["high"], most, 1e-6), f"von Mises from {field['low']} to {field['high']} instead of 0 to {most}")
    return data


def picture(driver, canvas):
    return driver.execute_script("return document.getElementById(arguments[0]).toDataURL()", canvas)


def check_sliders(driver, data):
    """Arrow keys on a slider give another picture, and back the same."""
    for name, count in (("z-slider", data["maps"]["count"][2]), ("step-slider", len(data["maps"]["steps"]))):
        if count < 2:
            continue
        before, knob = picture(driver, "field-map"), driver.find_element(By.ID, name)
        knob.send_keys(Keys.ARROW_LEFT)
        until(lambda before=before: picture(driver, "field-map") != before, f"{name} does not move the picture")
        knob.send_keys(Keys.ARROW_RIGHT)
        until(lambda before=before: picture(driver, "field-map") == before, f"{name} does not bring the picture back")
    if data["image"] and not isinstance(data["image"], str):
        before = picture(driver, "specimen-map")
        driver.execute_script("document.querySelector('input[name=layer][value=materials]').click()")
        until(lambda: picture(driver, "specimen-map") != before, "materials look as the image does")
    before = picture(driver, "field-map")
    driver.execute_script("document.querySelectorAll('input[name=field]')[1].click()")
    until(lambda: picture(driver, "field-map") != before, "another field does not give another picture")
    driver.execute_script("document.querySelectorAll('input[name=field]')[0].click()")
    until(lambda: picture(driver, "field-map") == before, "the field does not come back")


def probe(driver):
    return driver.find_element(By.ID, "probe").text


def value_of(text, name):
    words = text.replace("\n", " ").split(name, 1)[1].split()
    return float(words[0])


def check_pointer(driver, data, place):
    """What is under the pointer, by keys and by mouse."""
    canvas = driver.find_element(By.ID, "field-map")
    canvas.send_keys(Keys.ARROW_RIGHT)
    until(lambda: "von mises" in probe(driver), "an arrow key does not show a value")
    before = probe(driver)
    canvas.send_keys(Keys.ARROW_DOWN)
    until(lambda: probe(driver) != before, "an arrow key does not move the pointer")
    if place is None:
        return
    maps = data["maps"]
    at = [(place[d] - maps["origin"][d]) / maps["cell"][d] for d in range(3)]
    driver.execute_script("""const slider = document.getElementById("z-slider"); slider.value = arguments[0]; slider.dispatchEvent(new Event("input"));
        const canvas = document.getElementById("field-map"), box = canvas.getBoundingClientRect();
        canvas.dispatchEvent(new PointerEvent("pointermove", {clientX: box.left + arguments[1] * box.width, clientY: box.top + arguments[2] * box.height}))""",
        int(at[2]), at[0] / maps["count"][0], at[1] / maps["count"][1])
    until(lambda: near(value_of(probe(driver), "von mises stress"), place[3], 5e-4), f"'{probe(driver)}' instead of {place[3]} Pa")


def check_tables(driver, folder):
    """Histogram, curves against the distance to the wall, and objects are those of the tables."""
    rows = rows_of(folder / "histograms.csv")
    least = min(low for low, row in zip(numbers(rows, "low"), rows[1:]) if row[1] == "von_mises")
    drawn = [point for one in series(driver, "histogram-chart") for point in one["data"]]
    expect(near(min(point["x"] for point in drawn), least, 1e-12), "the histogram begins elsewhere")

    means = numbers(rows_of(folder / "wall_distance.csv"), "von_mises_mean")
    drawn = {point["y"] for one in series(driver, "wall-chart") for point in one["data"]}
    expect(drawn.issuperset(means), "a mean stress by the distance to the wall is not drawn")

    rows = rows_of(folder / "objects.csv")
    volumes = numbers(rows, "volume")
    shown = driver.execute_script("return [...document.querySelectorAll('#objects tbody tr')].map((row) => row.firstElementChild.textContent)")
    expect(len(shown) == min(15, len(volumes)), f"{len(shown)} objects of {len(volumes)} are shown")
    expect(volumes[int(shown[0]) - 1] == max(volumes), "the first object is not the largest")


def check_run(driver, folder, place):
    check_layout(driver, folder / "report.html")
    open_page(driver, folder / "report.html", 1280, "light")
    data = check_history(driver, folder)
    check_tables(driver, folder)
    check_sliders(driver, data)
    check_pointer(driver, data, place)


def check_study(driver, folder):
    check_layout(driver, folder / "report.html")
    open_page(driver, folder / "report.html", 1280, "light")
    rows, unit = rows_of(folder / "study.csv"), unit_of(driver, "force-chart")
    curves = series(driver, "force-chart")
    expect(len(curves) == len(rows) - 1, f"{len(curves)} curves of {len(rows) - 1} members")
    force = next(name for name in rows[0] if name.endswith(".force"))
    for curve, value in zip(curves, numbers(rows, force)):
        expect(near(curve["data"][-1]["y"] * unit, value, 1e-12), f"{curve['label']}: not the force of study.csv")
    if driver.find_elements(By.ID, "force-colours"):
        check_choices(driver, rows, len(curves))
    if series(driver, "figures-chart"):
        check_figures(driver, rows)
    if (folder / "bands.csv").exists():
        check_bands(driver, rows_of(folder / "bands.csv"))
    if (folder / "convergence.csv").exists():
        check_convergence(driver, rows_of(folder / "convergence.csv"))


def choose(driver, name, value):
    driver.execute_script("const list = document.getElementById(arguments[0]); list.value = arguments[1]; list.dispatchEvent(new Event('change'))", name, value)


def check_choices(driver, rows, members):
    """Of many members, those of one value may be looked at alone; each value has its colour."""
    column = [row[1] for row in rows[1:]]
    choose(driver, "force-only-0", column[0])
    until(lambda: len(series(driver, "force-chart")) == column.count(column[0]), f"other members than those of {rows[0][1]} {column[0]} are drawn")
    choose(driver, "force-only-0", "")
    until(lambda: len(series(driver, "force-chart")) == members, "not all members come back")
    for name in (rows[0][2], rows[0][1]):
        choose(driver, "force-colours", name)
        wanted = list(dict.fromkeys(row[rows[0].index(name)] for row in rows[1:]))
        until(lambda: driver.execute_script("return Chart.getChart('force-chart').legend.legendItems.map((item) => item.text)") == wanted, f"the legend does not tell the {name}")


def check_figures(driver, rows):
    """Each figure that can be chosen is drawn for each member."""
    for figure in driver.execute_script("return [...document.getElementById('figure').options].map((option) => option.value)"):
        choose(driver, "figure", figure)
        wanted = sorted(float(row[rows[0].index(figure)]) for row in rows[1:] if row[rows[0].index(figure)] != "")
        until(lambda: sorted(point["y"] for one in series(driver, "figures-chart") for point in one["data"]) == wanted, f"{figure} is not drawn")


def check_bands(driver, rows):
    unit, curves = unit_of(driver, "bands-chart"), {one["label"]: one["data"] for one in series(driver, "bands-chart")}
    for label, name in (("median of the draws, lower", "low"), ("median of the draws", "median"), ("median of the draws, upper", "high")):
        values = numbers(rows, name)
        expect(len(curves.get(label, [])) == len(values), f"bands.csv, {name}: not drawn")
        expect(all(near(point["y"] * unit, value, 1e-12) for point, value in zip(curves.get(label, []), values)), f"bands.csv, {name}: other values")


def check_convergence(driver, convergence):
    limit, order = (convergence[0].index(name) for name in ("extrapolated_force", "order"))
    shown = driver.execute_script("return [...document.querySelectorAll('#convergence tbody tr')].map((row) => [...row.children].map((field) => field.textContent))")
    unit = unit_of(driver, "convergence-chart")
    expect(len(shown) == len(convergence) - 1, "not all series of convergence.csv are shown")
    for row, line in zip(convergence[1:], shown):
        if row[limit] == "":
            expect(line[4] == "–", f"{line[0]} is extrapolated")
            continue
        expect(near(float(line[4]) * unit, float(row[limit]), 1e-5), f"{line[0]}: {line[4]} at size 0")
        expect(near(float(line[5]), float(row[order]), 1e-2), f"{line[0]}: order {line[5]}")
        ends = [one["data"][0] for one in series(driver, "convergence-chart") if one["label"] == f"{line[0]}, extrapolated"]
        expect(len(ends) == 1 and ends[0]["x"] == 0 and near(ends[0]["y"] * unit, float(row[limit]), 1e-12), f"{line[0]}: its limit is not drawn")


def check_fit(driver, folder):
    """Forces, misfits and correlations are those of the tables."""
    check_layout(driver, folder / "report.html")
    open_page(driver, folder / "report.html", 1280, "light")
    fitted, runs, estimates = (rows_of(folder / f"{name}.csv") for name in ("fitted", "fit", "estimates"))
    curves, unit = {one["label"]: one for one in series(driver, "fitted-chart")}, unit_of(driver, "fitted-chart")
    for label, column in (("measured", "measured"), ("fitted", "fitted"), ("first run", "start")):
        expect_curve(curves[label], numbers(fitted, column), unit, f"the {label} force")
    errors = [0.5 * (upper["y"] - lower["y"]) for lower, upper in zip(curves["measured, errors"]["data"][::3], curves["measured, errors"]["data"][1::3])]
    expect(all(near(error * unit, wanted, 1e-9) for error, wanted in zip(errors, numbers(fitted, "error"))), "the bars are not the errors")
    left = [(m - f) / e for m, f, e in zip(*(numbers(fitted, name) for name in ("measured", "fitted", "error")))]
    expect_curve(series(driver, "fitted-residual-chart")[0], left, 1.0, "what is left")
    misfits = [float(row[runs[0].index("chi2")]) for row in runs[1:] if row[runs[0].index("status")] == "done"]
    expect_curve(series(driver, "misfit-chart")[0], misfits, 1.0, "the misfit")
    shown = driver.execute_script("return [...document.querySelectorAll('#estimates tbody tr')].map((row) => [...row.children].map((field) => field.textContent))")
    expect([row[0] for row in shown] == [row[0] for row in estimates[1:]], "not all numbers are shown")
    for row, value in zip(shown, numbers(estimates, "value")):
        expect(near(float(row[1]), value, 1e-6), f"{row[0]} is {row[1]} instead of {value}")
    first = next(n for n, name in enumerate(estimates[0]) if name.startswith("correlation with "))
    tinted = driver.execute_script("return [...document.querySelectorAll('#correlations tbody tr')].map((row) => [...row.querySelectorAll('td')].map((field) => field.textContent))")
    expect(tinted == [[f"{float(field):.3f}" for field in row[first:]] for row in estimates[1:]], "the correlations are others")


def young_along(compliance, direction):
    """1 / (S_ijkl n_i n_j n_k n_l), by all its 81 components; rows of compliance are xx yy zz yz xz xy."""
    row = {(0, 0): 0, (1, 1): 1, (2, 2): 2, (1, 2): 3, (0, 2): 4, (0, 1): 5}
    total = 0.0
    for i, j, k, l in itertools.product(range(3), repeat=4):
        a, b = row[min(i, j), max(i, j)], row[min(k, l), max(k, l)]
        total += compliance[a][b] / ((1 if a < 3 else 2) * (1 if b < 3 else 2)) * direction[i] * direction[j] * direction[k] * direction[l]
    return 1.0 / total


def check_directions(driver, found):
    """Young's modulus around three planes is that of the compliances."""
    for plane in ("xy", "xz", "yz"):
        chart = f"young-{plane}"
        unit = UNITS[driver.find_element(By.ID, chart).get_attribute("aria-label").split()[-1]]
        labels = driver.execute_script("return Chart.getChart(arguments[0]).data.labels", chart)
        count = len(labels)
        ends = [labels[n * count // 4] for n in range(2)]  # up, right
        vectors = [[("xyz"[d] == end[-1]) * (-1.0 if end[0] == "-" else 1.0) for d in range(3)] for end in ends]
        curves = {one["label"]: one["data"] for one in series(driver, chart)}
        for name, one in found["stiffness"].items():
            if one["compliance"] is None:
                expect(name not in curves, f"{name} has no moduli, and is drawn")
                continue
            for n in range(0, count, 15):
                turn = 2.0 * math.pi * n / count
                direction = [math.cos(turn) * up + math.sin(turn) * right for up, right in zip(*vectors)]
                wanted = young_along(one["compliance"], direction)
                expect(near(curves[name][n] * unit, wanted, 1e-9), f"{name} along {direction}: {curves[name][n] * unit} instead of {wanted}")


def fields(driver, selector):
    return driver.execute_script("return [...document.querySelectorAll(arguments[0])].map((row) => [...row.children].map((field) => field.textContent))", selector)


def check_tensor(driver, name, matrix):
    """The table of a tensor, when it is chosen."""
    driver.execute_script("document.querySelector(`input[name=boundary][value='${arguments[0]}']`).click()", name)
    shown, most = [[float(field) for field in row[1:]] for row in fields(driver, "#tensor tbody tr")], max(map(max, matrix))
    unit = UNITS[driver.find_element(By.CSS_SELECTOR, "#tensor-section .note").text.split(";")[0].split()[-1]]
    expect(all(abs(a * unit - b) <= 1e-4 * most for row, wanted in zip(shown, matrix) for a, b in zip(row, wanted)), f"the tensor {name} is another")


def check_stiffness(driver, folder):
    """Tensors, moduli, bounds and load cases are those of stiffness.json."""
    check_layout(driver, folder / "report.html")
    open_page(driver, folder / "report.html", 1280, "light")
    found = json.loads((folder / "stiffness.json").read_text(encoding="utf-8"))
    check_directions(driver, found)
    for name, one in found["stiffness"].items():
        check_tensor(driver, name, one["stiffness"])
    for name in ("Voigt", "Reuss"):
        if found[name] is not None:
            check_tensor(driver, name, found[name])
    cases = [[unit, *[str(one["load cases"][unit]["iterations"]) for one in found["stiffness"].values()]] for unit in found["order"]]
    expect([[row[0], *row[1::2]] for row in fields(driver, "#cases tbody tr")] == cases, "the load cases are others")
    for row in fields(driver, "#moduli tbody tr"):
        name, unit = row[0].split()[0].replace("ν", "nu"), UNITS[row[0].split("(")[1].rstrip(")")] if "(" in row[0] else 1.0
        wanted = [one["moduli"][name] for one in found["stiffness"].values() if one["moduli"]]
        expect(all(near(float(text) * unit, value, 1e-3) for text, value in zip(row[1:], wanted)), f"{name} is {row[1:]} instead of {wanted}")
    if found["bounds"] is not None:
        unit, ends = unit_of(driver, "order-chart"), [one["data"][0]["y"] for one in series(driver, "order-chart")]
        expect(all(near(end * unit, found["bounds"]["Reuss"][letter], 1e-9) for end, letter in zip(ends, "KGE")), "Reuss's bounds are others")
    knob, pictures = driver.find_element(By.ID, "z-slider"), {picture(driver, "specimen-map")}
    knob.send_keys(Keys.HOME)
    for _ in range(int(knob.get_attribute("max"))):
        knob.send_keys(Keys.ARROW_RIGHT)
        pictures.add(picture(driver, "specimen-map"))
    expect(len(pictures) > 1, "the slider does not move the picture")


def main():
    kind, folder = sys.argv[1], Path(sys.argv[2])
    with browser() as driver:
        if kind == "run":
            check_run(driver, folder, [float(word) for word in sys.argv[3:7]] or None)
        elif kind == "fit":
            check_fit(driver, folder)
        elif kind == "stiffness":
            check_stiffness(driver, folder)
        elif kind == "says":
            open_page(driver, folder / "report.html", 1280, "light")
            page = driver.find_element(By.ID, "main").text
            for text in sys.argv[3:]:
                expect((text.lstrip("!") in page) != text.startswith("!"), f"the page and '{text}'")
        elif kind == "layout":
            check_layout(driver, folder / "report.html")
        else:
            check_study(driver, folder)
        check_quiet(driver)
    for what in WRONG:
        print(what)
    return 1 if WRONG else 0


if __name__ == "__main__":
    sys.exit(main())
