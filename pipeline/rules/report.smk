from pipeline.ground.input.words_by_file import by_file
from pipeline.report.end_of_job.stale_reports import WORDS
from pipeline.ground.words.left_out import to_json
from pipeline.models.interface import names_with_motion

TITLES = [f"{model}={config['models'][model]['title']}" for model in MODELS]
WHOLE_MOTION = [model for model in MODELS if model in names_with_motion()]
OF_MATERIAL = [*SHOWN, "index.html"]  # what is made of every material


# Functions, whose words Snakemake leaves as they are: a folder's name may look like a wildcard.
def refused_of_material(wildcards):
    return to_json([one for one in PLAN.refused if one.material == wildcards.material])


def fits_within(wildcards):
    return [fit for model in MODELS for fit in fits(config["models"], wildcards.material, only=model)]


rule table:
    input:
        metrics="processed/{material}/metrics.parquet",
        dataset="processed/{material}/dataset.parquet",
        left_out="processed/{material}/left_out.json",
        jumps="processed/{material}/zero_jumps.json",
    output:
        expand("reports/{{material}}/{file}", file=TABLES),
    log:
        "processed/logs/table-{material}.log",
    resources:
        **NEEDS["table"],
    params:
        titles=TITLES,
        made_by=mark_of_material,
        planned=refused_of_material,
        code=fingerprint("pipeline.report.tables"),
    message:
        "write Tables I and II of {wildcards.material}"
    shell:
        "exec python -m pipeline.report.tables {input.metrics:q} --dataset {input.dataset:q} --titles {params.titles:q}"
        " --left-out {input.left_out:q} --planned {params.planned:q} --jumps {input.jumps:q}"
        " --made-by {params.made_by:q} --out-dir reports/{wildcards.material:q} > {log:q} 2>&1"


rule comparison:
    input:
        metrics="processed/{material}/metrics.parquet",
        dataset="processed/{material}/dataset.parquet",
        jumps="processed/{material}/zero_jumps.json",
    output:
        page="reports/{material}/comparison.md",
        html="reports/{material}/comparison.html",
    log:
        "processed/logs/comparison-{material}.log",
    resources:
        **NEEDS["comparison"],
    params:
        titles=TITLES,
        made_by=mark_of_material,
        code=fingerprint("pipeline.report.comparison", "pipeline.report.web.*"),
    message:
        "compare {wildcards.material} with the paper"
    shell:
        "exec python -m pipeline.report.comparison {input.metrics:q} --dataset {input.dataset:q}"
        " --titles {params.titles:q} --jumps {input.jumps:q} --made-by {params.made_by:q} --out {output.page:q}"
        " > {log:q} 2>&1"


rule models:
    input:
        metrics="processed/{material}/metrics.parquet",
        dataset="processed/{material}/dataset.parquet",
        jumps="processed/{material}/zero_jumps.json",
    output:
        page="reports/{material}/models.md",
        html="reports/{material}/models.html",
        table="reports/{material}/models.csv",
        columns="reports/{material}/models.csv-metadata.json",
    log:
        "processed/logs/models-{material}.log",
    resources:
        **NEEDS["models"],
    params:
        titles=TITLES,
        directed=[model for model, settings in config["models"].items() if settings["direction"]],
        whole_motion=WHOLE_MOTION,
        made_by=mark_of_material,
        code=fingerprint("pipeline.report.models", "pipeline.report.web.*"),
    message:
        "hold the models of {wildcards.material} against its floor"
    shell:
        "exec python -m pipeline.report.models {input.metrics:q} --dataset {input.dataset:q} --titles {params.titles:q}"
        " --directed {params.directed:q} --whole-motion {params.whole_motion:q} --jumps {input.jumps:q}"
        " --made-by {params.made_by:q} --out {output.page:q} --table {output.table:q} > {log:q} 2>&1"


rule croissant:
    input:
        "processed/{material}/dataset.parquet",
    output:
        "reports/{material}/croissant.json",
    log:
        "processed/logs/croissant-{material}.log",
    resources:
        **NEEDS["croissant"],
    params:
        made_by=mark_of_material,
        code=fingerprint("pipeline.report.croissant"),
    message:
        "describe the dataset of {wildcards.material} for other programs"
    shell:
        "exec python -m pipeline.report.croissant {input:q} --made-by {params.made_by:q} --out {output:q} > {log:q} 2>&1"


rule figures:
    input:
        dataset="processed/{material}/dataset.parquet",
        metrics="processed/{material}/metrics.parquet",
        predictions=fits_within,
    output:
        expand("reports/{{material}}/{file}", file=FIGURES),
    log:
        "processed/logs/figures-{material}.log",
    resources:
        **NEEDS["figures"],
    params:
        titles=TITLES,
        whole_motion=WHOLE_MOTION,
        made_by=mark_of_material,
        code=fingerprint("pipeline.report.figures"),
    message:
        "draw Figures 4 and 5 of {wildcards.material}"
    shell:
        "exec python -m pipeline.report.figures {input.dataset:q} {input.metrics:q} --predictions {input.predictions:q}"
        " --titles {params.titles:q} --whole-motion {params.whole_motion:q} --made-by {params.made_by:q}"
        " --out-dir reports/{wildcards.material:q} > {log:q} 2>&1"


def leak_of_material(wildcards):
    return [figure for figure in LEAK_FIGURES if Path(figure).parent.name == wildcards.material]


# Which of its runs were tared anew stands in their run.yaml.
def described_of_material(wildcards):
    return described(runs_of(wildcards))


rule material_page:
    input:
        expand("reports/{{material}}/{file}", file=SHOWN),
        leak_of_material,
        described_of_material,
        dataset="processed/{material}/dataset.parquet",
        jumps="processed/{material}/zero_jumps.json",
    output:
        "reports/{material}/index.html",
    log:
        "processed/logs/material_page-{material}.log",
    resources:
        **NEEDS["material_page"],
    params:
        runs=folders_of_runs,
        made_by=mark_of_material,
        code=fingerprint("pipeline.report.material_page", "pipeline.report.web.*"),
    message:
        "write the page that shows the tables and figures of {wildcards.material}"
    shell:
        "exec python -m pipeline.report.material_page reports/{wildcards.material:q} --dataset {input.dataset:q}"
        " --runs {params.runs:q} --jumps {input.jumps:q} --made-by {params.made_by:q} > {log:q} 2>&1"


rule metrics:
    input:
        expand("processed/{material}/metrics.parquet", material=MATERIALS),
    output:
        table="reports/metrics.csv",
        columns="reports/metrics.csv-metadata.json",
    log:
        "processed/logs/metrics.log",
    resources:
        **NEEDS["metrics"],
    params:
        made_by=MARK_OF_ALL,
        code=fingerprint("pipeline.report.metrics"),
    message:
        "gather the metrics of all materials"
    shell:
        "exec python -m pipeline.report.metrics {input:q} --made-by {params.made_by:q} --out {output.table:q} > {log:q} 2>&1"


# What the stages left out: of materials by their datasets, of other runs in place of their strokes.
LEFT_OUT = expand("processed/{material}/left_out.json", material=MATERIALS) + expand(
    "processed/{run}/strokes.parquet", run=PLAN.others
)


JUMPS = expand("processed/{material}/zero_jumps.json", material=MATERIALS)


def words_of_index(wildcards):
    named = [*MATERIALS, "--runs", *DIAGNOSED, "--strings", json.dumps(PLAN.materials)]
    named += ["--left-out", *LEFT_OUT, "--planned", to_json(PLAN.left_out), "--jumps", *JUMPS]
    return by_file(named, WORDS, COPY)


def words_of_left_out(wildcards):
    return by_file(["--left-out", *LEFT_OUT, "--planned", to_json(PLAN.refused)], WORDS, COPY)


rule index:
    input:
        rules.metrics.output,
        expand("reports/{material}/{file}", material=MATERIALS, file=OF_MATERIAL),
        LEAK_FIGURES,
        expand("reports/diagnosis/{run}", run=DIAGNOSED),
        LEFT_OUT,
        JUMPS,
    output:
        "reports/index.html",
        directory("reports/pages"),
    log:
        "processed/logs/index.log",
    resources:
        **NEEDS["index"],
    params:
        words=words_of_index,
        made_by=MARK_OF_ALL,
        rig_mark=mark_of("synthetic"),
        code=fingerprint("pipeline.report.index", "pipeline.report.web.*"),
    message:
        "write the page that leads to every report"
    shell:
        "exec python -m pipeline.report.index {params.words:q} --made-by {params.made_by:q}"
        " --rig-mark {params.rig_mark:q} --reports reports --out {output[0]:q} > {log:q} 2>&1"


# It asks in a second, so a cluster's own machine does.
localrules:
    left_out,


# It fails where a run was refused, after everything else is made, so that this is not overlooked.
rule left_out:
    input:
        LEFT_OUT,
        last=["reports/index.html", "reports/metrics.csv"],
    output:
        "processed/left_out.json",
    log:
        "processed/logs/left_out.log",
    resources:
        **NEEDS["left_out"],
    params:
        words=words_of_left_out,
        code=fingerprint("pipeline.report.left_out"),
    message:
        "ask whether every run was taken"
    shell:
        "exec python -m pipeline.report.left_out {params.words:q} --out {output:q} > {log:q} 2>&1"
