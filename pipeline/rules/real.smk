from pipeline.real.runs_to_make import plan_of

REAL = plan_of(config)
if REAL.said:
    print(f"recordings: {REAL.said}", file=sys.stderr)


def real_file(wildcards):
    return REAL[wildcards.run].file


def real_mapping(wildcards):
    return REAL[wildcards.run].mapping


def real_group(wildcards):
    return [f"processed/real/raw/{run}" for run in REAL.groups(wildcards.rig)[wildcards.group]]


def real_group_verdicts(wildcards):
    return [f"reports/real/{wildcards.rig}/{run}" for run in REAL.groups(wildcards.rig)[wildcards.group]]


def verdicts_of_rig(wildcards):
    return [f"reports/real/{wildcards.rig}/{run}" for run in REAL.runs(wildcards.rig)]


def real_together(wildcards):
    return [f"reports/real/{wildcards.rig}/together/{group}" for group in REAL.groups(wildcards.rig)]


def real_black_boxes(wildcards):
    return [f"processed/real/black_box/{run}.json" for run in REAL.runs(wildcards.rig)]


def real_transfer(wildcards):
    return [f"processed/real/transfer/{wildcards.rig}/{group}.csv" for group in REAL.groups(wildcards.rig)]


wildcard_constraints:
    rig="(?!index)[a-z0-9_]+",
    group="[a-z0-9-]+",


# A file that cannot be imported or decided stops nothing: the pages say why.
rule bring:
    input:
        file=real_file,
        mapping=real_mapping,
    output:
        directory("processed/real/raw/{run}"),
    log:
        "processed/logs/bring-{run}.log",
    resources:
        **NEEDS["bring"],
    params:
        code=fingerprint("pipeline.real.bring", "pipeline.formats.*"),
    message:
        "import {wildcards.run}"
    shell:
        "exec python -m pipeline.real.bring {input.file:q} --map {input.mapping:q} --out {output:q} > {log:q} 2>&1"


rule real_verdicts:
    input:
        "processed/real/raw/{run}",
    output:
        directory("reports/real/{rig}/{run}"),
    log:
        "processed/logs/real_verdicts-{rig}-{run}.log",
    resources:
        **NEEDS["real_verdicts"],
    params:
        code=fingerprint("pipeline.real.verdicts", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "diagnose {wildcards.run}"
    shell:
        "exec python -m pipeline.real.verdicts {input:q} --out {output:q} > {log:q} 2>&1"


rule real_verdicts_together:
    input:
        real_group,
    output:
        directory("reports/real/{rig}/together/{group}"),
    log:
        "processed/logs/real_verdicts_together-{rig}-{group}.log",
    resources:
        **NEEDS["real_verdicts_together"],
    params:
        code=fingerprint("pipeline.real.verdicts", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "diagnose all of {wildcards.group} of {wildcards.rig} together"
    shell:
        "exec python -m pipeline.real.verdicts {input:q} --out {output:q} > {log:q} 2>&1"


rule black_box:
    input:
        "processed/real/raw/{run}",
    output:
        "processed/real/black_box/{run}.json",
    log:
        "processed/logs/black_box-{run}.log",
    resources:
        **NEEDS["black_box"],
    params:
        code=fingerprint("pipeline.real.black_box"),
    message:
        "ask black boxes about {wildcards.run}"
    shell:
        "exec python -m pipeline.real.black_box {input:q} --out {output:q} > {log:q} 2>&1"


rule transfer:
    input:
        runs=real_group,
        diagnoses=real_group_verdicts,
    output:
        table="processed/real/transfer/{rig}/{group}.csv",
        others=directory("processed/real/others/{rig}/{group}"),
    log:
        "processed/logs/transfer-{rig}-{group}.log",
    resources:
        **NEEDS["transfer"],
    params:
        code=fingerprint("pipeline.real.transfer", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "ask what was learnt on each of {wildcards.group} about the others"
    shell:
        "exec python -m pipeline.real.transfer {input.runs:q} --group {wildcards.group:q}"
        " --diagnoses reports/real/{wildcards.rig:q} --others {output.others:q} --out {output.table:q} > {log:q} 2>&1"


rule real_page:
    input:
        verdicts=verdicts_of_rig,
        together=real_together,
        black_boxes=real_black_boxes,
        transfer=real_transfer,
        known=Path(workflow.basedir) / "pipeline/config/real.yaml",
    output:
        page="reports/real/{rig}.html",
        figure="reports/real/{rig}.png",
        table="processed/real/table/{rig}.csv",
    log:
        "processed/logs/real_page-{rig}.log",
    resources:
        **NEEDS["real_page"],
    params:
        code=fingerprint("pipeline.report.real.page"),
    message:
        "write the page of {wildcards.rig}"
    shell:
        "exec python -m pipeline.report.real.page {wildcards.rig:q} --verdicts {input.verdicts:q}"
        " --together {input.together:q} --black-boxes {input.black_boxes:q} --transfer {input.transfer:q}"
        " --out {output.page:q} --figure {output.figure:q} --table {output.table:q} > {log:q} 2>&1"


rule real:
    input:
        REAL.tables,
    output:
        page="reports/real/index.html",
        table="reports/real/table.csv",
    log:
        "processed/logs/real.log",
    resources:
        **NEEDS["real"],
    params:
        code=fingerprint("pipeline.report.real.index"),
        passed_over=REAL.shown,
    message:
        "write the table over all public rigs"
    shell:
        "exec python -m pipeline.report.real.index {input:q} --out {output.page:q} --table {output.table:q}"
        " --passed-over {params.passed_over:q} > {log:q} 2>&1"
