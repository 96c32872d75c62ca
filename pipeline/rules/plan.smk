from pipeline.dag import make_plan
from pipeline.known_files import KnownFiles
from pipeline.usable import refusals

# What there is to make. A recording that ingest would refuse is left out of the plan, as one with a bad run.yaml is.
KNOWN = KnownFiles(Path(".snakemake/known_files.json"))
PLAN = make_plan(RAW, SYNTHETIC)
CONTENT = {run: KNOWN.digest(recorded_files(RAW, run, SYNTHETIC)) for run in PLAN.runs}
RECORDED = {run: content for run, content in CONTENT.items() if run not in SYNTHETIC}
READS = fingerprint("pipeline.ingest", "pipeline.systems.*")
UNUSABLE, KNOWN.notes["usable"] = refusals(RAW, RECORDED, READS, KNOWN.notes.get("usable"))
PLAN.leave_out(UNUSABLE)
