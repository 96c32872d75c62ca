"""What the main job costs on a cluster, by measured jobs: CPU hours, submissions, bytes and the least wall time.

    python benchmarks/cluster_cost.py

A model, not a measurement: jobs were measured one by one (benchmarks/jobs.py), their sum on many nodes was not. A run
is one of nine strokes, 20 runs are of one material, a node has 16 processors, and a fit takes as long as it has points.
"""

EVALUATE_S = 3.7  # CPU: Snakemake starts and evaluates the Snakefile; the same for 1 and for 1,000 runs, 4.3 for 10,000
START_S = 1.0  # SLURM starts a job; not measured apart
CHECK_S = 30.0  # until the end of a submission is noticed, on average, as checks go from 10 s apart to 180 s
RUN_S = {"ingest": 1.6, "strokes": 0.8, "diagnose": 32.0}
# CPU seconds of one fit of one run's points, and how many fits the default configuration asks for
FITS = {
    "inn": (38.0, 10),
    "cinn": (16.0, 10),
    "mlp": (14.0, 10),
    "diagnosed": (32.0, 2),
    "spline": (2.1, 2),
    "polynomial": (1.5, 2),
    "calibrated": (1.5, 2),
    "traditional": (0.7, 2),
}
PAGES_S = {
    "dataset": 1.8,
    "floor": 1.3,
    "evaluate": 0.9,
    "table": 0.8,
    "comparison": 0.8,
    "models": 0.9,
    "figures": 4.4,
}
RUN_MB, MATERIAL_MB = 1.8, 80.0  # recording, samples, diagnosis; forty models with their predictions
RUNS_A_MATERIAL, PROCESSORS = 20, 16
BUNDLES = {"run": 10, "diagnoses": 4, "fits": 4}


def main() -> None:
    """Print the table."""
    fits = sum(count for _, count in FITS.values())
    of_fits_s = sum(seconds * count for seconds, count in FITS.values())
    heads = (
        "runs",
        "jobs",
        "submissions",
        "CPU h",
        "overhead, CPU h (unbundled)",
        "GB",
        "1 node",
        "10 nodes",
        "100 nodes",
    )
    print(f"| {' | '.join(heads)} |\n|{'---|' * len(heads)}")
    for runs in (100, 1_000, 10_000):
        materials = runs // RUNS_A_MATERIAL
        jobs = len(RUN_S) * runs + (fits + len(PAGES_S)) * materials
        sent = runs / BUNDLES["run"] + runs / BUNDLES["diagnoses"] + materials * (fits / BUNDLES["fits"] + 2)
        work_s = runs * (sum(RUN_S.values()) + of_fits_s) + materials * sum(PAGES_S.values())
        bundled_s = jobs * EVALUATE_S + sent * (EVALUATE_S + START_S)
        alone_s = jobs * (2 * EVALUATE_S + START_S)
        longest_s = BUNDLES["fits"] * (RUNS_A_MATERIAL * FITS["inn"][0] + EVALUATE_S) + 4 * CHECK_S + 120
        walls = [(work_s + bundled_s) / (nodes * PROCESSORS) + longest_s for nodes in (1, 10, 100)]
        gigabytes = (runs * RUN_MB + materials * MATERIAL_MB) / 1000
        cells = [f"{runs:,}", f"{jobs:,}", f"{sent:,.0f}", f"{work_s / 3600:,.0f}"]
        cells += [f"{bundled_s / 3600:,.1f} ({alone_s / 3600:,.1f})", f"{gigabytes:,.1f}"]
        print(f"| {' | '.join([*cells, *(f'{wall / 3600:.1f} h' for wall in walls)])} |")


if __name__ == "__main__":
    main()
