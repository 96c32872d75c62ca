CAMPAIGN = config["campaign"]
CAMPAIGN_FIGURES = expand("reports/campaign/{figure}.{suffix}", figure=("few_shot", "coverage"), suffix=("png", "pdf"))


def title_of(model):
    return config["models"].get(model, {}).get("title", model)


def campaign_settings(wildcards):
    return json.dumps(CAMPAIGN["models"][wildcards.learner], sort_keys=True)


def code_of_learner(wildcards):
    return fingerprint("pipeline.stages.campaign.few_shot", f"pipeline.models.{wildcards.learner}")


wildcard_constraints:
    learner="[a-z_]+",


rule record_campaign:
    output:
        directory("processed/campaign/raw"),
    log:
        "processed/logs/campaign-record.log",
    resources:
        **NEEDS["record_campaign"],
    params:
        strings=CAMPAIGN["strings"],
        seed=CAMPAIGN["seed"],
        code=fingerprint("pipeline.rig.campaign.*", "pipeline.rig.effects.*"),
    message:
        "record {params.strings} strings on the synthetic rig"
    shell:
        "exec python -m pipeline.rig.campaign --strings {params.strings:q} --seed {params.seed:q} --out {output:q} > {log:q} 2>&1"


rule campaign_points:
    input:
        "processed/campaign/raw",
    output:
        "processed/campaign/points.parquet",
    log:
        "processed/logs/campaign-points.log",
    resources:
        **NEEDS["campaign_points"],
    params:
        code=fingerprint("pipeline.stages.campaign.points"),
    message:
        "gather the points of the campaign's strings"
    shell:
        "exec python -m pipeline.stages.campaign.points {input:q} --out {output:q} > {log:q} 2>&1"


rule campaign_floor:
    input:
        "processed/campaign/points.parquet",
    output:
        "processed/campaign/floor.parquet",
    log:
        "processed/logs/campaign-floor.log",
    resources:
        **NEEDS["campaign_floor"],
    params:
        code=fingerprint("pipeline.stages.campaign.floor"),
    message:
        "ask what no model of the campaign's strings can beat"
    shell:
        "exec python -m pipeline.stages.campaign.floor {input:q} --out {output:q} > {log:q} 2>&1"


rule few_shot:
    input:
        "processed/campaign/points.parquet",
    output:
        "processed/campaign/few_shot/{learner}.parquet",
    log:
        "processed/logs/campaign-few_shot-{learner}.log",
    benchmark:
        "processed/logs/campaign-few_shot-{learner}.tsv"
    threads: 1
    resources:
        **NEEDS["few_shot"],
    params:
        settings=campaign_settings,
        code=code_of_learner,
    message:
        "ask {wildcards.learner} about new strings, from few of their strokes"
    shell:
        "exec python -m pipeline.stages.campaign.few_shot {input:q} --model {wildcards.learner:q}"
        " --settings {params.settings:q} --out {output:q} > {log:q} 2>&1"


rule coverage:
    input:
        "processed/campaign/points.parquet",
    output:
        "processed/campaign/coverage.parquet",
    log:
        "processed/logs/campaign-coverage.log",
    benchmark:
        "processed/logs/campaign-coverage.tsv"
    threads: 1
    resources:
        **NEEDS["coverage"],
    params:
        model=CAMPAIGN["coverage"]["model"],
        strings=CAMPAIGN["coverage"]["strings"],
        settings=json.dumps(CAMPAIGN["coverage"]["settings"], sort_keys=True),
        code=fingerprint("pipeline.stages.campaign.coverage", f"pipeline.models.{CAMPAIGN['coverage']['model']}"),
    message:
        "hold the intervals of {params.model} against what came, on {params.strings} strings"
    shell:
        "exec python -m pipeline.stages.campaign.coverage {input:q} --model {params.model:q} --settings {params.settings:q}"
        " --strings {params.strings:q} --out {output:q} > {log:q} 2>&1"


rule campaign:
    input:
        points="processed/campaign/points.parquet",
        few_shot=expand("processed/campaign/few_shot/{learner}.parquet", learner=CAMPAIGN["models"]),
        floor="processed/campaign/floor.parquet",
        coverage="processed/campaign/coverage.parquet",
    output:
        figures=CAMPAIGN_FIGURES,
        tables=expand("reports/campaign/{table}.csv", table=("few_shot", "coverage")),
        columns=expand("reports/campaign/{table}.csv-metadata.json", table=("few_shot", "coverage")),
        page="reports/campaign/campaign.md",
        html="reports/campaign/campaign.html",
    log:
        "processed/logs/campaign.log",
    resources:
        **NEEDS["campaign"],
    params:
        titles=[f"{model}={title_of(model)}" for model in CAMPAIGN["models"]],
        model=title_of(CAMPAIGN["coverage"]["model"]),
        made_by=mark_of("campaign"),
        code=fingerprint("pipeline.report.campaign.page", "pipeline.report.web.*"),
    message:
        "write the page of the campaign"
    shell:
        "exec python -m pipeline.report.campaign.page {input.points:q} --few-shot {input.few_shot:q} --floor {input.floor:q}"
        " --coverage {input.coverage:q} --titles {params.titles:q} --intervals-of {params.model:q}"
        " --made-by {params.made_by:q} --out-dir reports/campaign > {log:q} 2>&1"
