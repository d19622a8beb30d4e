#!/usr/bin/env python3
"""Adds heyoka, SciPy and SUNDIALS to a work-precision diagram of Residua.

    residua bench precision planar-paper spatial-paper --out DIR
    python3 models/tools/rivals.py DIR/planar-paper.csv DIR/spatial-paper.csv

Reads NAME.csv and NAME.json beside it, writes NAME.all.csv with the same columns, and NAME.all.svg and NAME.all.png if
matplotlib is there. Lanes are added for what is installed: heyoka, scipy, sksundae (SUNDIALS). Only the planar and the
spatial pendulum are known here. Times are the shortest of some runs after one that is not timed, and of the integration
alone: what heyoka compiles just in time is left out. SciPy and SUNDIALS call a right-hand side in Python, as their users do.
"""

import argparse
import csv
import json
import math
import pathlib
import sys
import time

TOLERANCES = [10.0**-k for k in range(2, 16)]
TOGETHER = 0.5  # s, for the timed runs of one kind
COLUMNS = ["trajectory", "phase", "energy", "constraint", "momentum"]
ANGLE = 1.5  # rad: beyond, angles are compared by sine and cosine


class Planar:
    """J w' = -m g l sin(theta), theta' = w."""

    models = ["planar_angle"]

    def __init__(self, scene):
        p = {name: values[0] for name, values in scene["parameters"].items()}
        self.inertia, self.torque = p["J"], p["m"] * p["g"] * p["l"]
        self.model = "planar_angle"
        self.start = scene["start"]["omega"] + scene["start"]["theta"]
        self.end = scene["end"]["omega"] + scene["end"]["theta"]
        self.scales = scene["scales"]["omega"] + scene["scales"]["theta"]

    def rates(self, t, x):
        return [-self.torque / self.inertia * math.sin(x[1]), x[0]]

    def symbols(self, hy):
        w, theta = hy.make_vars("w", "theta")
        return [(w, -self.torque / self.inertia * hy.sin(theta)), (theta, w)]

    def error(self, x):
        (w, theta), (end_w, end_theta) = x, self.end
        errors = [abs(w - end_w) / self.scales[0]]
        if self.scales[1] <= ANGLE:
            errors.append(abs(theta - end_theta) / self.scales[1])
        else:
            errors.append(abs(math.sin(theta) - math.sin(end_theta)))
            errors.append(abs(math.cos(theta) - math.cos(end_theta)))
        return largest(errors)

    def energy(self, x):
        kinetic, potential = self.inertia * x[0] ** 2 / 2, self.torque * math.cos(x[1])
        return kinetic - potential, abs(kinetic) * 2 + self.torque


class Spatial:
    """J w' = -w x J w + m g rho x G, G' = -w x G for one row of R or for three."""

    def __init__(self, scene, rows):
        p = scene["parameters"]
        self.j = [p["J"][3 * i : 3 * i + 3] for i in range(3)]
        self.inverse = inverse(self.j)
        self.arm = [p["m"][0] * p["g"][0] * r for r in p["rho"]]
        self.model = "spatial_reduced" if len(rows) == 1 else "spatial_group"
        names = ["omega"] + rows
        pick = lambda record: [value for name in names for value in record[name]]
        self.start, self.end, self.scales = (pick(scene[k]) for k in ("start", "end", "scales"))

    def right_side(self, x):
        w, vertical = x[:3], x[-3:]
        momentum = [dot(row, w) for row in self.j]
        torque = [a - b for a, b in zip(cross(self.arm, vertical), cross(w, momentum))]
        rates = [dot(row, torque) for row in self.inverse]
        for i in range(3, len(x), 3):
            rates += cross(x[i : i + 3], w)
        return rates

    def rates(self, t, x):
        return self.right_side(list(x))

    def symbols(self, hy):
        x = list(hy.make_vars(*(f"x{i}" for i in range(len(self.start)))))
        return list(zip(x, self.right_side(x)))

    def error(self, x):
        return largest(abs(a - b) / s for a, b, s in zip(x, self.end, self.scales))

    def energy(self, x):
        w, vertical = list(x[:3]), list(x[-3:])
        kinetic = dot(w, [dot(row, w) for row in self.j]) / 2
        potential = [a * b for a, b in zip(self.arm, vertical)]
        return kinetic - sum(potential), 2 * kinetic + sum(map(abs, potential))


def dot(a, b):
    # A term with a factor 0 is left out, as a generator would.
    terms = [p * q for p, q in zip(a, b) if not is_zero(p) and not is_zero(q)]
    return sum(terms[1:], terms[0]) if terms else 0.0


def is_zero(value):
    return isinstance(value, float) and value == 0.0


def cross(a, b):
    minus = lambda p, q: p if is_zero(q) else (-q if is_zero(p) else p - q)
    times = lambda p, q: 0.0 if is_zero(p) or is_zero(q) else p * q
    return [
        minus(times(a[1], b[2]), times(a[2], b[1])),
        minus(times(a[2], b[0]), times(a[0], b[2])),
        minus(times(a[0], b[1]), times(a[1], b[0])),
    ]


def inverse(m):
    columns = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]
    determinant = sum(a * b for a, b in zip(m[0], columns[0]))
    return [[columns[j][i] / determinant for j in range(3)] for i in range(3)]


def largest(errors):
    """Unlike max, keeps a NaN."""
    errors = list(errors)
    return math.nan if any(e != e for e in errors) else max(errors)


def heyoka_lanes(system, until):
    import heyoka as hy

    def lane(tolerance):
        ta = hy.taylor_adaptive(system.symbols(hy), list(system.start), tol=tolerance)

        def run():
            ta.time, ta.state[:] = 0.0, system.start
            outcome = ta.propagate_until(until)
            if outcome[0] != hy.taylor_outcome.time_limit:
                raise RuntimeError(str(outcome[0]))
            return list(ta.state), outcome[3]

        return run

    yield "heyoka", "taylor", lane


def scipy_lanes(system, until):
    from scipy.integrate import solve_ivp

    for method in ["DOP853", "RK45", "LSODA", "Radau"]:

        def lane(tolerance, method=method):
            def run():
                solved = solve_ivp(
                    system.rates, (0.0, until), system.start, method, t_eval=[until], rtol=tolerance, atol=tolerance
                )
                if not solved.success:
                    raise RuntimeError(solved.message)
                return list(solved.y[:, -1]), solved.nfev

            return run

        yield "scipy", method.lower(), lane


def sundials_lanes(system, until):
    from sksundae.cvode import CVODE

    for method in ["Adams", "BDF"]:

        def lane(tolerance, method=method):
            def rhs(t, y, rates):
                rates[:] = system.rates(t, y)

            solver = CVODE(rhs, method=method, rtol=tolerance, atol=tolerance, max_num_steps=10**7)

            def run():
                solved = solver.solve([0.0, until], system.start)
                if not solved.success:
                    raise RuntimeError(solved.message)
                return list(solved.y[-1]), int(solved.nfev)

            return run

        yield "sundials", method.lower(), lane


def lanes(system, until):
    for package in [heyoka_lanes, scipy_lanes, sundials_lanes]:
        try:
            yield from package(system, until)
        except ImportError as error:
            print(f"note: {error}: its lanes are left out", file=sys.stderr)


def rows(scene, system, arguments):
    for package, scheme, lane in lanes(system, scene["until"]):
        for tolerance in arguments.tolerances:
            row = {"scene": scene["scene"], "model": system.model, "scheme": scheme, "by": package}
            row |= {"step": "", "tolerance": tolerance, "steps": 0, "evaluations": 0, "failure": ""}
            row |= {"seconds": math.nan, "runs": 0} | dict.fromkeys(COLUMNS, math.nan)
            try:
                run = lane(tolerance)
                clock = time.perf_counter()
                end, row["evaluations"] = run()
                once = time.perf_counter() - clock
                row["trajectory"] = system.error(end)
                energy, size = system.energy(end)
                row["energy"] = abs(energy - system.energy(system.start)[0]) / size
                row["runs"] = max(1, min(arguments.runs, int(TOGETHER / once)))
                times = []
                for _ in range(row["runs"]):
                    clock = time.perf_counter()
                    run()
                    times.append(time.perf_counter() - clock)
                row["seconds"] = min(times)
            except (RuntimeError, ValueError, ArithmeticError) as error:
                row["failure"] = str(error).replace("\n", " ")
            yield row
            if row["seconds"] > arguments.limit:
                break


def systems(scene):
    parameters, states = set(scene["parameters"]), set(scene["start"])
    if {"m", "J", "l", "g"} == parameters and {"omega", "theta"} == states:
        return [Planar(scene)]
    if {"m", "J", "rho", "g"} == parameters:
        vertical = [name for name in ["Gamma3", "Gamma"] if name in states]
        whole = ["Gamma1", "Gamma2", "Gamma3"]
        lists = [vertical] + ([whole] if set(whole) <= states else [])
        return [Spatial(scene, rows) for rows in lists if rows]
    return []


def draw(all_rows, path, title):
    try:
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        return
    curves = {}
    for row in all_rows:
        curves.setdefault((row["by"], row["scheme"], row["model"]), []).append(row)
    named = {lane for level in [1e-3, 1e-6, 1e-9, 1e-11] for lane in best(curves, level)}
    figure, axes = plt.subplots(1, 2, figsize=(13, 6))
    for axis, kind in zip(axes, ["trajectory", "energy"]):
        for lane, own in curves.items():
            points = [(float(r[kind]), float(r["seconds"])) for r in own]
            points = [(x, y) if 0 < x <= 1 else (math.nan, math.nan) for x, y in points]
            style = {"label": " ".join(lane), "marker": "o", "zorder": 3} if lane in named else {"color": "0.85"}
            axis.loglog(*zip(*points), **style, markersize=3)
        axis.set_xlabel(f"{kind} error")
        axis.set_ylabel("time [s]")
    axes[0].legend(fontsize=7)
    figure.suptitle(title)
    for ending in ["svg", "png"]:
        figure.savefig(path.with_suffix(f".all.{ending}"), dpi=110)


def best(curves, level):
    """The fastest lane of each package at an error."""
    fastest = {}
    for lane, own in curves.items():
        times = [float(r["seconds"]) for r in own if float(r["trajectory"]) <= level]
        times = [t for t in times if t == t]
        if times and min(times) < fastest.get(lane[0], (math.inf, lane))[0]:
            fastest[lane[0]] = (min(times), lane)
    for package, (seconds, lane) in sorted(fastest.items(), key=lambda item: item[1][0]):
        print(f"    {level:.0e}  {seconds * 1e6:10.1f} µs  {' '.join(lane)}")
    return [lane for _, lane in fastest.values()]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("tables", nargs="+", type=pathlib.Path, metavar="NAME.csv")
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--limit", type=float, default=1.0, help="s: slower runs end a ladder")
    arguments = parser.parse_args()
    arguments.tolerances = TOLERANCES
    for path in arguments.tables:
        with open(path, newline="") as table, open(path.with_suffix(".json")) as description:
            reader = csv.DictReader(table)
            ours, scene = list(reader), json.load(description)
        known = systems(scene)
        if not known:
            print(f"note: {path}: neither the planar nor the spatial pendulum", file=sys.stderr)
        added = [row for system in known for row in rows(scene, system, arguments)]
        with open(path.with_suffix(".all.csv"), "w", newline="") as table:
            writer = csv.DictWriter(table, reader.fieldnames)
            writer.writeheader()
            writer.writerows(ours + added)
        print(scene["scene"])
        draw(ours + added, path, f"{scene['scene']}: {scene['caption']}")


if __name__ == "__main__":
    main()
