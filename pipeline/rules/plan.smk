import os

import yaml

from pipeline.ground.configuration import complete
from pipeline.workflow import handed_plan
from pipeline.report.layout.verdict_file import damage
from pipeline.workflow.dag import VERDICT, make_plan, table_order
from pipeline.workflow.known_files import KnownFiles
from pipeline.workflow.needs import Needs
from pipeline.workflow.storage import copy_of_storage
from pipeline.workflow.usable_recordings import refusals

# What there is to make. A recording that ingest would refuse is left out of the plan, as one with a bad run.yaml is.
# A node of a cluster, which evaluates all this again for one job, takes the plan of the start that sent it.
# What its reading gives is kept for ingest, where both see one processed/.
KNOWN = KnownFiles(Path(".snakemake/known_files.json"), {VERDICT: damage})
ON_NODE, COPY = workflow.remote_exec, copy_of_storage(workflow.storage_settings)
READS, READ_AHEAD = fingerprint("pipeline.stages.ingest", "pipeline.systems.*"), Path("processed/.read_ahead")
if ON_NODE and os.environ.get(handed_plan.PLAN):
    PLAN, RECORDED = handed_plan.unpacked(os.environ[handed_plan.PLAN])
    CONTENT = {}
else:
    PLAN = make_plan(RAW, SYNTHETIC)
    CONTENT = {run: KNOWN.digest(recorded_files(RAW, run, SYNTHETIC)) for run in PLAN.runs}
    RECORDINGS = {run: CONTENT[run] for run in PLAN.runs if run not in SYNTHETIC}
    UNUSABLE, KNOWN.notes["usable"] = refusals(
        RAW, RECORDINGS, READS, KNOWN.notes.get("usable"), None if COPY else READ_AHEAD
    )
    PLAN.leave_out(UNUSABLE)
    RECORDED = {run: recorded_files(RAW, run, SYNTHETIC) for run in PLAN.runs}
    if not ON_NODE:
        os.environ |= {
            handed_plan.PLAN: handed_plan.packed(PLAN, RECORDED),
            handed_plan.REFUSALS: "",
        }  # until it starts
os.environ.setdefault(handed_plan.REFUSALS, "")
workflow.register_envvars(handed_plan.PLAN, handed_plan.REFUSALS)
MATERIALS = list(PLAN.materials)
DIAGNOSED = PLAN.runs
# The tables' order is that of the default configuration, whatever a configuration on top of it begins with.
DEFAULT = yaml.safe_load((Path(workflow.basedir) / "pipeline/config/default.yaml").read_text(encoding="utf-8"))
for each in (config, DEFAULT):
    complete(each["models"])
MODELS = table_order(config["models"], DEFAULT["models"])
# What jobs may take, and where they start: without a shared file system, in a machine's own copy of the storage, in which
# a job's raw/, processed/ and reports/ lie.
NEEDS = Needs(PLAN.materials)
TO_COPY = f"mkdir -p {shlex.quote(COPY)} && cd {shlex.quote(COPY)} || exit 1; " if COPY else ""
# Jobs end with this Snakemake, and say at once what they say. How many threads one has is the package's own rule.
PREFIX = f"{TO_COPY}export PYTHONPATH={shlex.quote(workflow.basedir)} PYTHONUNBUFFERED=1 TWISTBENCH_PARENT=$PPID"
shell.prefix(f"{PREFIX} NOTE_REFUSALS={shlex.quote(os.environ[handed_plan.REFUSALS])}; ")
