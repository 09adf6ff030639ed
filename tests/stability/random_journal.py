#!/usr/bin/env python3
"""Writes a journal of acts of all kinds at random: random_journal.py START SEED ACTS. START is a journal whose first line says
what terrain it begins with, as 'talus run --ticks 0 --journal START' writes it; 1.3 km a side or a little more."""
import json
import random
import sys

start, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
rng = random.Random(seed)
extent_m = 1300.0
modes = ["raise", "lower", "smooth", "flatten", "ramp", "noise", "terrace", "stamp", "erode"]
materials = ["bedrock", "regolith", "water", "hardness", "mask", "rain"]
has_stamp = False


def dab():
    mode = rng.choice(modes if has_stamp else [mode for mode in modes if mode != "stamp"])
    material = rng.choice(materials)
    paints = mode in ("raise", "lower") and material in ("hardness", "mask", "rain")
    act = {"op": "dab", "mode": mode, "material": material, "x_m": rng.uniform(-0.1, 1.1) * extent_m,
           "y_m": rng.uniform(-0.1, 1.1) * extent_m, "radius_m": rng.uniform(20, 500), "falloff": rng.random(),
           "amount_m": rng.uniform(0, 20), "blend": rng.random(),
           "target_m": rng.random() * (500 if material == "rain" else 1) if paints else rng.uniform(0, 900),
           "curve": rng.choice(["smooth", "linear", "round", "sharp"]), "masked": rng.random() < 0.3 and material != "mask"}
    if mode == "ramp":
        act |= {"way_m": [rng.uniform(-300, 300), rng.uniform(-300, 300)], "rise_m": rng.uniform(-50, 50)}
    if mode == "terrace":
        act |= {"step_m": rng.uniform(5, 55), "flat": rng.uniform(0, 0.9)}
    if mode == "noise":
        act["noise"] = {"kind": rng.choice(["fbm", "ridged", "billow"]), "wavelength_m": rng.uniform(30, 330), "octaves": 4,
                        "gain": 0.5, "warp": rng.uniform(0, 0.2), "seed": rng.randrange(1000)}
    if mode == "stamp":
        act["stamp"] = {"mode": rng.choice(["add", "higher", "lower", "replace"]),
                        "half_m": [rng.uniform(60, 260), rng.uniform(60, 260)], "turn_deg": rng.uniform(0, 360),
                        "mirrored": rng.random() < 0.5, "zero": rng.random()}
    if mode == "erode":
        act["erode"] = {"rain_mm_per_h": rng.uniform(0, 5000), "time_s": rng.uniform(0.5, 3.5),
                        "acceleration": rng.uniform(1, 500), "begins": rng.random() < 0.25, "ends": rng.random() < 0.25}
    return act


def parameter():
    return rng.choice([
        lambda: ("thermal.repose_deg", None), lambda: ("thermal.repose_deg", rng.uniform(20, 45)),
        lambda: ("water.rain", rng.choice([0.0, rng.uniform(0, 300)])), lambda: ("erosion.on", rng.random() < 0.5),
        lambda: ("erosion.porosity", rng.uniform(0, 0.4)), lambda: ("erosion.acceleration", rng.uniform(1, 50)),
        lambda: ("erosion.over", rng.choice(["everywhere", "mask"])), lambda: ("erosion.strata_m", rng.uniform(0, 50)),
        lambda: ("water.manning", rng.uniform(0, 0.1)), lambda: ("water.boundary.east", rng.choice(["wall", "open"])),
        lambda: ("thermal.weathering", rng.uniform(0, 100)), lambda: ("water.sea_level", rng.uniform(0, 300))])()


for at, line in enumerate(open(start, encoding="utf-8")):
    if at == 0:
        print(line, end="")
for _ in range(count):
    kind = rng.randrange(20)
    if kind < 10:
        act = dab()
    elif kind < 13:
        act = {"op": "ticks", "count": rng.randrange(1, 5)}
    elif kind == 13:
        act = {"op": "spring", "x_m": rng.random() * 0.8 * extent_m, "y_m": rng.random() * 0.8 * extent_m, "rate_m3_per_s": rng.uniform(0, 5)}
    elif kind == 14:
        west, south = rng.uniform(0, 900), rng.uniform(0, 900)
        act = {"op": "stamp", "piece": {"west_m": west, "south_m": south, "east_m": west + 300, "north_m": south + 250}}
        has_stamp = True
    elif kind == 15:
        low = rng.uniform(0, 40)
        act = {"op": "mask", "from": rng.choice(["slope", "height", "curvature"]), "low": low, "high": low + 30, "fade": rng.uniform(0, 5),
               "join": rng.choice(["replace", "add", "intersect", "subtract"]), "inverted": rng.random() < 0.5}
    elif kind == 16:
        act = {"op": "blur", "deviation_m": rng.uniform(0, 60), "of": rng.choice(["ground", "mask"]), "masked": rng.random() < 0.5}
    elif kind == 17:
        act = {"op": "turn", "quarters": rng.choice([1, 2, 3])}
    else:
        name, value = parameter()
        act = {"op": "set", "name": name, "value": value}
    print(json.dumps(act))
