#!/usr/bin/python3
"""Linear iterations of the rubber fit over Poisson's ratio, mesh and contact stiffness.

Usage: benchmarks/solver_counts.py [--ranks N] [--output DIR] [--set "Section/Entry=value"]...

Each number is the mean over the Newton iterations of the first two steps, to the
tolerance that the drivers use with pressures as unknowns.
"""
import os

from run_driver import ROOT, parser, run

FILE = os.path.join(ROOT, "prm/rubber_fit.prm")
RATIOS = ["0.45", "0.49", "0.499", "0.4999"]
MESHES = {"16, 7, 20": "14, 3, 18", "31, 10, 23": "17, 4, 10", "46, 15, 34": "25, 6, 15"}
SCALES = ["2", "20", "200"]


def count(ratio, rubber, seat, scale, arguments):
    settings = [
        "Solver/Linear/Type=iterative",
        "Steps/First step=0.05",
        "Steps/Largest step=0.05",
        "Steps/Maximum steps=2",
        "Output/Every=0",
        f"Rubber/Cells={rubber}",
        f"Seat/Cells={seat}",
        f"Rubber/Poisson's ratio={ratio}",
        f"Contact/Stiffness scale={scale}",
    ]
    summary, _ = run("rubber_fit", FILE, "run", settings, arguments)
    if summary["status"] not in ("finished", "most steps"):
        return summary["status"]
    mean = summary["linear_iterations"] / summary["newton_iterations"]
    failed = f", {summary['cut_backs']} cut-backs" if summary["cut_backs"] else ""
    return f"{mean:.0f} ({summary['newton_iterations']}{failed})"


def main():
    arguments = parser(__doc__, "solver_counts").parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    lines = ["Linear iterations per Newton iteration (Newton iterations of two steps)", ""]
    lines += ["| cells of the rubber | contact scale | " + " | ".join(RATIOS) + " |"]
    lines += ["|" + "---|" * (2 + len(RATIOS))]
    for rubber, seat in MESHES.items():
        for scale in SCALES:
            row = [count(ratio, rubber, seat, scale, arguments) for ratio in RATIOS]
            lines.append(f"| {rubber} | {scale} | " + " | ".join(row) + " |")
            print(lines[-1], flush=True)
    with open(os.path.join(arguments.output, "table.md"), "w") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
