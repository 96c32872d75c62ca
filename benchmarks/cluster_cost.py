"""What the main job costs on a cluster, by measured jobs: CPU hours, submissions, bytes and the least wall time.

    python benchmarks/cluster_cost.py [--queue-min 0 10]

A model, not a measurement: jobs were measured one by one (benchmarks/jobs.py), and submissions on a SLURM of two nodes
on one machine (tests/cluster); their sum on many nodes was not. A run is one of nine strokes. Assumed are how long a
submission waits for other people's jobs, how many runs are of one material, what a node is, and that a fit takes as
long as it has points.
"""

import argparse

# Measured: CPU seconds, but for START_S and the two CHECKs, which are seconds of the clock.
EVALUATE_S = 3.4  # Snakemake starts, imports and evaluates the Snakefile on a node, for each job and each submission
START_S = 2.5  # from the end of a submission to the start of the next one on its node, of 9: 1.9 to 2.8
CHECK_S = 16.0  # until the end of a submission of a minute is noticed, mean of 14: 4 to 42
LONG_CHECK_S = 90.0  # the same of a long one: half of the 180 s that checks come to be apart; not measured
RUN_S = {"ingest": 1.7, "diagnose": 14.2}
# one fit of one run's points, and how many fits the default configuration asks for
FITS = {
    "inn": (38.0, 10),
    "cinn": (16.0, 10),
    "mlp": (14.0, 10),
    "diagnosed": (14.2, 2),
    "spline": (2.1, 2),
    "polynomial": (1.5, 2),
    "calibrated": (1.5, 2),
    "traditional": (0.7, 2),
}
PAGES_S = {"dataset": 1.8, "floor": 1.3, "evaluate": 0.9, "table": 0.8, "comparison": 0.8, "models": 0.9}
PAGES_S |= {"figures": 4.4, "croissant": 0.6, "material_page": 0.6}
# Bytes: of a run its recording 0.66, samples and strokes 0.26, diagnosis 0.90; of each run in its material its part of
# the dataset 0.24, and of the predictions of each fit and floor 0.066; of a material its pages 0.9
RUN_MB, DATASET_MB, PREDICTIONS_MB, PAGES_MB, FLOORS = 1.8, 0.24, 0.066, 0.9, 4

# Assumed
QUEUE_MIN = (0.0, 10.0)  # minutes that each submission waits for a processor
RUNS_A_MATERIAL, PROCESSORS = 20, 16

BUNDLES = {"run": 10, "diagnoses": 4, "fits": 4}  # env/slurm/profile.yaml
CHAIN = ("run", "material", "fits", "pages", "last")  # submissions that follow each other


def longest_s(queue_s: float) -> float:
    """Seconds that no number of nodes shortens: one submission after the other, the longest of each kind."""
    short = BUNDLES["run"] * (RUN_S["ingest"] + EVALUATE_S)
    short += sum(PAGES_S.values()) + len(PAGES_S) * EVALUATE_S
    fits = BUNDLES["fits"] * (RUNS_A_MATERIAL * FITS["inn"][0] + EVALUATE_S) + LONG_CHECK_S
    return short + fits + len(CHAIN) * (queue_s + START_S + EVALUATE_S) + (len(CHAIN) - 1) * CHECK_S


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--queue-min", type=float, nargs="+", default=QUEUE_MIN, help="assumed wait of a submission")
    queues = parser.parse_args().queue_min
    fits = sum(count for _, count in FITS.values())
    of_fits_s = sum(seconds * count for seconds, count in FITS.values())
    heads = ["runs", "jobs", "submissions", "CPU h", "overhead, CPU h (unbundled)", "GB", "queue (assumed)"]
    heads += ["1 node", "10 nodes", "100 nodes"]
    print(f"| {' | '.join(heads)} |\n|{'---|' * len(heads)}")
    for runs in (100, 1_000, 10_000):
        materials = runs // RUNS_A_MATERIAL
        jobs = len(RUN_S) * runs + (fits + len(PAGES_S)) * materials
        sent = runs / BUNDLES["run"] + runs / BUNDLES["diagnoses"] + materials * (fits / BUNDLES["fits"] + 2)
        work_s = runs * (sum(RUN_S.values()) + of_fits_s) + materials * sum(PAGES_S.values())
        bundled_s, alone_s = (jobs + sent) * EVALUATE_S, 2 * jobs * EVALUATE_S
        of_run_mb = RUN_MB + DATASET_MB + (fits + FLOORS) * PREDICTIONS_MB
        cells = [f"{runs:,}", f"{jobs:,}", f"{sent:,.0f}", f"{work_s / 3600:,.0f}"]
        cells += [f"{bundled_s / 3600:,.1f} ({alone_s / 3600:,.1f})"]
        cells += [f"{(runs * of_run_mb + materials * PAGES_MB) / 1000:,.1f}"]
        for queue_min in queues:
            busy_s = work_s + bundled_s + sent * START_S
            walls = [busy_s / (nodes * PROCESSORS) + longest_s(60.0 * queue_min) for nodes in (1, 10, 100)]
            print(f"| {' | '.join([*cells, f'{queue_min:g} min', *(f'{wall / 3600:.1f} h' for wall in walls)])} |")


if __name__ == "__main__":
    main()
