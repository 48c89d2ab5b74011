#!/usr/bin/python3
"""The same scenes by CalculiX (Debian: calculix-ccx) and by contact_scene, in one run.

Usage: benchmarks/calculix.py [--case NAME]... [--method NAME]... [--size N]... [--repeat N]
         [--ranks N] [--output DIR]

Cases, of trilinear hexahedra in both programs, with the same meshes, the same linear
penalty and one thread:
  patch         two blocks that do not match under a pressure: error of the stresses
  interference  two steel tubes, overlap 0.05 (Lame: 67.6082): error of the motion
  press         a block pressed into another, meshes of growing size: time, iterations
  ironing       a stiff cylinder pressed into rubber and slid over it: ripple of the force
CalculiX by face-to-face penalty, node-to-face penalty and mortar (where it has it);
ours by segments, points and nodes. Writes DIR/table.md. Runs interleaved; times are
medians, of whole processes.
"""
import csv
import glob
import os
import shutil
import subprocess
import sys
import time

import numpy as np

from run_driver import parser, run

FACES = {"bottom": "S1", "top": "S2", "front": "S3", "right": "S4", "back": "S5", "left": "S6"}
KINDS = {
    "ccx face-to-face": "SURFACE TO SURFACE",
    "ccx node-to-face": "NODE TO SURFACE",
    "ccx mortar": "MORTAR",
}
OURS = {"segments": [], "points": ["points"], "nodes": ["nodes"]}


class Body:
    """A box of cells, mapped; nodes and elements numbered from given offsets."""

    def __init__(self, name, low, high, cells, E, nu, mapping=None, law="elastic"):
        self.name, self.low, self.high, self.cells = name, low, high, cells
        self.E, self.nu, self.mapping, self.law = E, nu, mapping, law

    def number(self, first_node, first_element):
        nx, ny, nz = self.cells
        x = [np.linspace(self.low[i], self.high[i], self.cells[i] + 1) for i in range(3)]
        self.node = lambda i, j, k: first_node + i + (nx + 1) * (j + (ny + 1) * k)
        self.nodes = {}
        for k in range(nz + 1):
            for j in range(ny + 1):
                for i in range(nx + 1):
                    p = (x[0][i], x[1][j], x[2][k])
                    self.nodes[self.node(i, j, k)] = self.mapping(*p) if self.mapping else p
        self.elements, self.sides = {}, {side: [] for side in FACES}
        e = first_element
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    n = self.node
                    self.elements[e] = [n(i, j, k), n(i + 1, j, k), n(i + 1, j + 1, k), n(i, j + 1, k),
                                        n(i, j, k + 1), n(i + 1, j, k + 1), n(i + 1, j + 1, k + 1),
                                        n(i, j + 1, k + 1)]
                    for side, is_there in (("bottom", k == 0), ("top", k == nz - 1), ("front", j == 0),
                                           ("back", j == ny - 1), ("left", i == 0), ("right", i == nx - 1)):
                        if is_there:
                            self.sides[side].append(e)
                    e += 1
        return max(self.nodes) + 1, e

    def nodes_of(self, side):
        nx, ny, nz = self.cells
        ranges = {"bottom": (slice(None), slice(None), [0]), "top": (slice(None), slice(None), [nz]),
                  "front": (slice(None), [0], slice(None)), "back": (slice(None), [ny], slice(None)),
                  "left": ([0], slice(None), slice(None)), "right": ([nx], slice(None), slice(None))}
        def pick(n, r):
            return range(n + 1) if isinstance(r, slice) else r
        a, b, c = ranges[side]
        return [self.node(i, j, k) for k in pick(nz, c) for j in pick(ny, b) for i in pick(nx, a)]


def numbers(values):
    """Lists of the deck, sixteen in a line."""
    values = [str(v) for v in values]
    return ",\n".join(", ".join(values[i : i + 16]) for i in range(0, len(values), 16)) + "\n"


def deck(case, kind):
    """CalculiX's input of a case."""
    out, first_node, first_element = [], 1, 1
    for b in case["bodies"]:
        first_node, first_element = b.number(first_node, first_element)
        out.append(f"*NODE, NSET=N{b.name}\n")
        out += [f"{n}, {p[0]:.12g}, {p[1]:.12g}, {p[2]:.12g}\n" for n, p in b.nodes.items()]
        out.append(f"*ELEMENT, TYPE=C3D8, ELSET=E{b.name}\n")
        out += [f"{e}, " + ", ".join(map(str, nodes)) + "\n" for e, nodes in b.elements.items()]
        for side in FACES:
            out.append(f"*NSET, NSET={b.name}{side}\n" + numbers(b.nodes_of(side)))
            out.append(f"*SURFACE, NAME=S{b.name}{side}\n")
            out += [f"{e}, {FACES[side]}\n" for e in b.sides[side]]
        out.append(f"*MATERIAL, NAME=M{b.name}\n")
        if b.law == "elastic":
            out.append(f"*ELASTIC\n{b.E}, {b.nu}\n")
        else:
            mu, K = b.E / (2 * (1 + b.nu)), b.E / (3 * (1 - 2 * b.nu))
            out.append(f"*HYPERELASTIC, NEO HOOKE\n{mu / 2:.12g}, {2 / K:.12g}\n")
        out.append(f"*SOLID SECTION, ELSET=E{b.name}, MATERIAL=M{b.name}\n")
    (sb, ss), (pb, ps) = case["contact"]
    out.append(f"*CONTACT PAIR, INTERACTION=I, TYPE={KINDS[kind]}\nS{sb}{ss}, S{pb}{ps}\n"
               f"*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n"
               f"{case['penalty']:.12g}\n")
    out.append("*BOUNDARY\n")
    out += [f"{s}, {c}, {c}, 0.\n" for s, c in case["held"]]
    for step in case["steps"]:
        out.append(f"*STEP, INC=10000{', NLGEOM' if case.get('large') else ''}\n*STATIC\n"
                   f"{step['first']}, 1., 1e-6, {step['first']}\n")
        if "prescribed" in step:
            out.append("*BOUNDARY\n")
            out += [f"{s}, {c}, {c}, {v:.12g}\n" for s, c, v in step["prescribed"]]
        if "pressure" in step:
            body, side, p = step["pressure"]
            out.append("*DLOAD\n")
            b = next(x for x in case["bodies"] if x.name == body)
            out += [f"{e}, P{FACES[side][1]}, {p}\n" for e in b.sides[side]]
        print_set = case["force_at"]
        out.append(f"*NODE PRINT, NSET={print_set}, TOTALS=ONLY\nRF\n")
        if case.get("stresses"):
            for b in case["bodies"]:
                out.append(f"*EL PRINT, ELSET=E{b.name}\nS\n")
        if "probe" in case:
            out.append("*NODE PRINT, NSET=PROBE\nU\n")
        out.append("*END STEP\n")
    text = "".join(out)
    if "probe" in case:
        body, index = case["probe"]
        b = next(x for x in case["bodies"] if x.name == body)
        text = text.replace("*CONTACT PAIR", f"*NSET, NSET=PROBE\n{b.node(*index)}\n*CONTACT PAIR", 1)
    return text


def run_ccx(case, kind, folder):
    """Time, iterations, increments, cut-backs and the blocks of the .dat file."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    with open(os.path.join(folder, "job.inp"), "w") as file:
        file.write(deck(case, kind))
    environment = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")
    start = time.time()
    try:
        process = subprocess.run(["ccx", "job"], cwd=folder, env=environment, timeout=1800,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        seconds, text = time.time() - start, process.stdout.decode(errors="replace")
    except subprocess.TimeoutExpired:
        return {"finished": False, "why": "stopped after 30 min", "seconds": 1800.0}
    with open(os.path.join(folder, "job.log"), "w") as file:
        file.write(text)
    result = {"seconds": seconds, "finished": process.returncode == 0 and "Job finished" in text
              and "*ERROR" not in text, "why": ""}
    if not result["finished"]:
        errors = [line.strip() for line in text.splitlines() if "*ERROR" in line or "diverge" in line]
        if not errors and process.returncode != 0:
            errors.append(f"ended with code {process.returncode}, without a word")
        result["why"] = (errors or ["no convergence"])[-1][:70]
    with open(os.path.join(folder, "job.sta")) as file:
        rows = [line.split() for line in file if line.split() and line.split()[0].isdigit()]
    last = {}
    for row in rows:
        last[(row[0], row[1])] = max(int(row[2]), last.get((row[0], row[1]), 0))
    result["steps"] = len(last)
    result["cut_backs"] = sum(attempt - 1 for attempt in last.values())
    with open(os.path.join(folder, "job.cvg")) as file:
        result["iterations"] = sum(1 for line in file if line.split() and line.split()[0].isdigit())
    forces, stresses, motion, times, mode = [], [], None, [], None
    with open(os.path.join(folder, "job.dat")) as file:
        for line in file:
            if "time" in line:
                mode = "f" if "total force" in line else "s" if "stresses" in line else "u"
                t = float(line.split("time")[1].split()[0])
                if mode == "f":
                    times.append(t)
            elif line.strip():
                values = [float(v) for v in line.split()]
                if mode == "f":
                    forces.append(values)
                elif mode == "s":
                    stresses.append(values[2:])
                elif mode == "u":
                    motion = values[1:]
    result.update(times=np.array(times), forces=np.array(forces), stresses=np.array(stresses),
                  motion=motion)
    return result


def prm(case, folder):
    """contact_scene's file of a case."""
    ids = {"left": 0, "right": 1, "front": 2, "back": 3, "bottom": 4, "top": 5}
    t = ["set Driver = contact_scene", "subsection Bodies",
         "  set Names = " + ", ".join(b.name for b in case["bodies"])]
    for b in case["bodies"]:
        law = "linear elastic" if b.law == "elastic" else "neo-Hookean"
        t += [f"  subsection {b.name}", "    subsection Mesh",
              "      set Lower corner = " + ", ".join(f"{v:.12g}" for v in b.low),
              "      set Upper corner = " + ", ".join(f"{v:.12g}" for v in b.high),
              "      set Cells = " + ", ".join(map(str, b.cells))]
        if b.mapping:
            t.append(f"      set Map = {case['maps'][b.name]}")
        t += ["    end", "    subsection Material", f"      set Law = {law}",
              f"      set Young's modulus = {b.E}", f"      set Poisson's ratio = {b.nu}", "    end", "  end"]
    conditions = []
    held = {}
    for where, component in case["held"]:
        held.setdefault(where, []).append(component)
    prescribed = {}
    for n, step in enumerate(case["steps"]):
        for where, component, value in step.get("prescribed", []):
            prescribed.setdefault(where, {}).setdefault(component, []).append((n, value))
    for where in sorted(set(held) | set(prescribed)):
        name = next(b.name for b in case["bodies"] if where.startswith(b.name))
        values = {c: "0" for c in held.get(where, [])}
        for c, list_of in prescribed.get(where, {}).items():
            formula, before = "", 0.0
            for n, value in list_of:
                formula += f" + {value - before:.12g}*min(1, max(0, t - {n}))"
                before = value
            values[c] = formula.lstrip(" +")
        lines = [f"    set {'xyz'[c - 1]} = {v}" for c, v in sorted(values.items())]
        conditions.append((where, [f"    set Body = {name}",
                                   f"    set Boundary ids = {ids[where[len(name):]]}"] + lines))
    for step in case["steps"]:
        if "pressure" in step:
            body, side, p = step["pressure"]
            conditions.append(("load", [f"    set Body = {body}", f"    set Boundary ids = {ids[side]}",
                                        "    set Type = pressure", f"    set Pressure = {p}*t"]))
    t += ["end", "subsection Boundary conditions", "  set Names = " + ", ".join(c for c, _ in conditions)]
    for name, lines in conditions:
        t += [f"  subsection {name}"] + lines + ["  end"]
    (sb, ss), (pb, ps) = case["contact"]
    t += ["end", "subsection Contact", "  set Interfaces = i", "  subsection i",
          f"    set Secondary = {sb}: boundary {ids[ss]}", f"    set Primary = {pb}: boundary {ids[ps]}",
          "    set Law = linear", "    set Stiffness side = secondary", "    set Stiffness scale = 10",
          f"    set Characteristic length = {case['length']:.12g}",
          f"    set Stiffness = {case['penalty'] * case['length']:.12g}", "  end", "end"]
    if "probe" in case:
        body, index = case["probe"]
        b = next(x for x in case["bodies"] if x.name == body)
        t += ["subsection Probes", "  set Names = p", "  subsection p", f"    set Body = {body}",
              "    set Point = " + ", ".join(f"{v:.12g}" for v in b.nodes[b.node(*index)]), "  end", "end"]
    first = case["steps"][0]["first"]
    t += ["subsection Steps", f"  set End time = {len(case['steps'])}", f"  set First step = {first}",
          "  set Times to meet = " + ", ".join(str(n + 1) for n in range(len(case["steps"]))), "end",
          "subsection Solver", "  subsection Newton", "    set Force tolerance = 1e-6",
          "    set Displacement tolerance = 1e-4", "  end", "end",
          "subsection Output", "  set Every = 0", "end"]
    path = os.path.join(folder, "scene.prm")
    os.makedirs(folder, exist_ok=True)
    with open(path, "w") as file:
        file.write("\n".join(t) + "\n")
    return path


def run_ours(case, settings, name, arguments):
    folder = os.path.join(arguments.output, name.replace(" ", "_"))
    path = prm(case, folder + "_input")
    start = time.time()
    summary, folder = run("contact_scene", path, name, settings, arguments)
    result = {"seconds": time.time() - start, "finished": summary["status"] == "finished", "why": "",
              "steps": summary["steps"], "cut_backs": summary["cut_backs"],
              "iterations": summary["newton_iterations"]}
    if not result["finished"]:
        result["why"] = f"to {summary['time']:.3g}"
        return result
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    where = case["force_at"]
    result["times"] = np.array([float(r["time"]) for r in rows])
    if f"reaction:{where}_x" in rows[0]:
        result["forces"] = np.array([[float(r[f"reaction:{where}_{c}"]) for c in "xyz"] for r in rows])
    if "probe" in case:
        result["motion"] = summary["probes"]["p"]
    if case.get("stresses"):
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy
        stresses = []
        files = glob.glob(os.path.join(folder, "solution-*.vtu"))
        last = max(path.rsplit("-", 1)[1] for path in files)
        for path in [path for path in files if path.endswith(last)]:
            reader = vtk.vtkXMLUnstructuredGridReader()
            reader.SetFileName(path)
            reader.Update()
            data = reader.GetOutput().GetCellData()
            if not data.HasArray("stress_zz"):
                data = reader.GetOutput().GetPointData()
            stresses.append(np.column_stack([vtk_to_numpy(data.GetArray("stress_" + c))
                                             for c in ("xx", "yy", "zz")]))
        result["stresses"] = np.vstack(stresses)
    return result


# --- cases -----------------------------------------------------------------------------


def blocks(n, m, overlap=0.0):
    h = 1.0 / n
    return [Body("lower", (0, 0, 0), (1, 1, 1), (n, n, max(1, n // 2)), 1000.0, 0.3),
            Body("upper", (0, 0, 1 - overlap), (1, 1, 2), (m, m, max(1, m // 2)), 1000.0, 0.3)], h


def patch():
    # what only touches is held by nothing
    bodies, h = blocks(3, 4, 1e-4)
    return {
        "bodies": bodies, "contact": (("lower", "top"), ("upper", "bottom")),
        "penalty": 20 * 1000.0 / h, "length": h,
        "held": [("lowerbottom", 3), ("lowerleft", 1), ("lowerfront", 2), ("upperleft", 1),
                 ("upperfront", 2)],
        "steps": [{"first": 1.0, "pressure": ("upper", "top", 1.0)}],
        "force_at": "lowerbottom", "stresses": True,
    }


def patch_error(case, result):
    s = result["stresses"]
    return max(np.abs(s[:, 2] + 1.0).max(), np.abs(s[:, :2]).max())


def interference():
    def tube(r, phi, z):
        return (r * np.cos(phi), r * np.sin(phi), z)
    half = np.pi / 2
    bodies = [Body("inner", (20.0, 0.0, 0.0), (40.025, half, 2.0), (10, 96, 1), 210000.0, 0.3, tube),
              Body("outer", (39.975, 0.0, 0.0), (60.0, half, 2.0), (10, 128, 1), 210000.0, 0.3, tube)]
    held = [(f"{b}{s}", c) for b in ("inner", "outer")
            for s, c in (("front", 2), ("back", 1), ("bottom", 3), ("top", 3))]
    return {
        "bodies": bodies, "contact": (("inner", "right"), ("outer", "left")),
        "maps": {b: "x*cos(y); x*sin(y); z" for b in ("inner", "outer")},
        "penalty": 20 * 210000.0 / 2.6, "length": 2.6, "held": held,
        "steps": [{"first": 1.0}], "force_at": "innerfront", "probe": ("inner", (10, 0, 0)),
    }


def interference_error(case, result):
    # BENCHMARKS A5 b: the inner tube's outer face moves by -0.0145089
    return abs(result["motion"][0] / -0.0145089 - 1.0)


def press(n):
    bodies, h = blocks(n, n + 1)
    return {
        "bodies": bodies, "contact": (("lower", "top"), ("upper", "bottom")),
        "penalty": 20 * 1000.0 / h, "length": h,
        "held": [("lowerbottom", c) for c in (1, 2, 3)] + [("uppertop", 1), ("uppertop", 2)],
        "steps": [{"first": 0.25, "prescribed": [("uppertop", 3, -0.02)]}], "force_at": "lowerbottom",
    }


def ironing():
    """A rubber block of 4 x 1, and a stiff cylinder of radius 1 over it: pressed 0.2 in,
    slid by 2. One cell thick, plane strain."""
    def drum(x, y, z):
        # z = 0: the arc below, z = 1: its top
        low = 2.02 - np.sqrt(1.0 - x * x)
        return (x + 1.0, y, low * (1 - z) + 1.6 * z)
    bodies = [Body("block", (0, 0, 0), (4, 0.1, 1), (60, 1, 10), 10.0, 0.3, law="rubber"),
              Body("drum", (-0.7, 0, 0), (0.7, 0.1, 1), (24, 1, 5), 1000.0, 0.3, drum, law="rubber")]
    flat = [(f"{b}{s}", 2) for b in ("block", "drum") for s in ("front", "back")]
    return {
        "bodies": bodies, "contact": (("block", "top"), ("drum", "bottom")), "large": True,
        "maps": {"drum": "x + 1; y; (2.02 - sqrt(1 - x*x))*(1 - z) + 1.6*z"},
        "penalty": 20 * 10.0 / 0.1, "length": 0.2,
        "held": flat + [("blockbottom", 1), ("blockbottom", 3)],
        "steps": [{"first": 0.05, "prescribed": [("drumtop", 1, 0.0), ("drumtop", 3, -0.2)]},
                  {"first": 0.01, "prescribed": [("drumtop", 1, 2.0), ("drumtop", 3, -0.2)]}],
        "force_at": "blockbottom",
    }


def ripple(case, result):
    """Rms of the second difference of the vertical force over its mean, while slid, at
    equal times."""
    t, f = result["times"], result["forces"][:, 2]
    grid = np.arange(1.2, 1.95, 0.01)
    if t[-1] < 1.95:
        return float("nan")
    f = np.interp(grid, t, f)
    return np.sqrt(np.mean(np.diff(f, 2) ** 2)) / abs(f.mean())


CASES = {
    "patch": ([patch()], patch_error, "stress error"),
    "interference": ([interference()], interference_error, "error of the motion"),
    "press": ([press(n) for n in (8, 16, 24)], None, ""),
    "ironing": ([ironing()], ripple, "ripple of the force"),
}


def main():
    options = parser(__doc__, "calculix")
    options.add_argument("--case", action="append", choices=list(CASES))
    options.add_argument("--method", action="append", choices=list(KINDS) + list(OURS))
    options.add_argument("--size", action="append", type=int, help="of press: cells along an edge")
    options.add_argument("--repeat", type=int, default=1)
    options.set_defaults(ranks=1)
    arguments = options.parse_args()
    if not shutil.which("ccx"):
        sys.exit("CalculiX is missing: apt-get install calculix-ccx")
    os.makedirs(arguments.output, exist_ok=True)
    methods = arguments.method or list(KINDS) + list(OURS)
    lines = []
    for name in arguments.case or CASES:
        variants, measure, title = CASES[name]
        if name == "press" and arguments.size:
            variants = [press(n) for n in arguments.size]
        lines += [f"## {name}", "", f"| method | nodes | finished | increments | iterations | cut-backs "
                  f"| seconds | {title} |", "|" + "---|" * 8]
        for case in variants:
            n_nodes = 0
            results, seconds = {}, {}
            for _ in range(arguments.repeat):
                for kind in [k for k in KINDS if k in methods]:
                    folder = os.path.join(arguments.output, f"{name}_{kind}".replace(" ", "_"))
                    results[kind] = run_ccx(case, kind, folder)
                    seconds.setdefault(kind, []).append(results[kind]["seconds"])
                    print(f"{name} {kind}: {results[kind]['seconds']:.1f} s {results[kind]['why']}", flush=True)
                for label in [o for o in OURS if o in methods]:
                    settings = [f"Contact/i/Integration={e}" for e in OURS[label]]
                    results[label] = run_ours(case, settings, f"{name} {label}", arguments)
                    seconds.setdefault(label, []).append(results[label]["seconds"])
            n_nodes = sum(len(b.nodes) for b in case["bodies"])
            for label, r in results.items():
                value = ""
                if measure and r["finished"]:
                    value = f"{measure(case, r):.2e}"
                lines.append(f"| {label} | {n_nodes} | {'yes' if r['finished'] else r['why']} "
                             f"| {r.get('steps', '')} | {r.get('iterations', '')} | {r.get('cut_backs', '')} "
                             f"| {np.median(seconds[label]):.2f} | {value} |")
        lines.append("")
        with open(os.path.join(arguments.output, "table.md"), "w") as file:
            file.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
