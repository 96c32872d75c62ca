"""twistbench: from recordings of a twisted string rig to the paper's tables and figures."""

import json
import shlex
import sys
from pathlib import Path

from snakemake.utils import min_version, validate

min_version("9.27")
sys.path.insert(0, workflow.basedir)

from pipeline.workflow.dag import SYNTHETIC_FILES, fits, recorded_files, stored
from pipeline.ground.code.fingerprint import fingerprint
from pipeline.report.end_of_job.summary import summary


configfile: str(Path(workflow.basedir) / "pipeline/config/default.yaml")


validate(config, str(Path(workflow.basedir) / "pipeline/config/schema.yaml"))
RAW, SYNTHETIC = Path("raw"), list(config["synthetic"])


include: "pipeline/rules/plan.smk"


TABLES = [f"table_{number}.{suffix}" for number in (1, 2) for suffix in ("csv", "csv-metadata.json", "md", "tex")]
FIGURES = [f"figure_{number}.{suffix}" for number in (4, 5) for suffix in ("png", "pdf")]
PAGES = ["comparison.md", "comparison.html", "models.md", "models.html", "models.csv", "models.csv-metadata.json"]
SHOWN = [*TABLES, *FIGURES, *PAGES, "croissant.json"]  # what the page of a material is made after
STAGES = "marks record ingest dataset train floor evaluate leak report diagnose proof real campaign known said"


wildcard_constraints:
    run="[a-z0-9][a-z0-9-]*",
    material="[A-Za-z0-9][A-Za-z0-9_-]*",
    model="|".join(config["models"]),
    split="within|later",
    seed="[0-9]+",
    batch="batch-[0-9]+|by_[a-z_]+-[0-9]+|without-[a-z_]+",


for stage in STAGES.split():

    include: f"pipeline/rules/{stage}.smk"


rule all:
    default_target: True
    input:
        expand("reports/{material}/{file}", material=MATERIALS, file=OF_MATERIAL),
        LEAK_FIGURES,
        expand("processed/{run}/strokes.parquet", run=PLAN.others),
        expand("reports/diagnosis/{run}", run=DIAGNOSED),
        "reports/metrics.csv",
        "reports/index.html",
        "processed/left_out.json",


# It runs whenever it is asked for, so that its end says where the tables lie, also where nothing is to be made.
rule tables:
    input:
        expand("reports/{material}/{file}", material=MATERIALS, file=TABLES),
    localrule: True
    message:
        "say where the tables lie"
    shell:
        "true"


rule diagnosis:
    input:
        expand("reports/diagnosis/{run}", run=DIAGNOSED),


rule proof:
    input:
        expand("reports/proof/{file}", file=PROOF_FILES),
        rules.proof_page.output,
