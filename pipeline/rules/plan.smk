import yaml

from pipeline.workflow.dag import make_plan, table_order
from pipeline.workflow.known_files import KnownFiles
from pipeline.workflow.usable import refusals

# What there is to make. A recording that ingest would refuse is left out of the plan, as one with a bad run.yaml is.
KNOWN = KnownFiles(Path(".snakemake/known_files.json"))
PLAN = make_plan(RAW, SYNTHETIC)
CONTENT = {run: KNOWN.digest(recorded_files(RAW, run, SYNTHETIC)) for run in PLAN.runs}
RECORDED = {run: content for run, content in CONTENT.items() if run not in SYNTHETIC}
READS = fingerprint("pipeline.stages.ingest", "pipeline.systems.*")
UNUSABLE, KNOWN.notes["usable"] = refusals(RAW, RECORDED, READS, KNOWN.notes.get("usable"))
PLAN.leave_out(UNUSABLE)
MATERIALS = list(PLAN.materials)
DIAGNOSED = PLAN.runs
# The tables' order is that of the default configuration, whatever a configuration on top of it begins with.
DEFAULT = yaml.safe_load((Path(workflow.basedir) / "pipeline/config/default.yaml").read_text(encoding="utf-8"))
MODELS = table_order(config["models"], DEFAULT["models"])
