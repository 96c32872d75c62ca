def folders_of_runs(wildcards):
    return expand("raw/{run}", run=PLAN.materials[wildcards.material])


def stages_of_runs(wildcards):
    runs, stages = PLAN.materials[wildcards.material], ["samples", "strokes"]
    return expand("raw/{run}/run.yaml", run=runs) + expand("processed/{run}/{stage}.parquet", run=runs, stage=stages)


rule dataset:
    input:
        stages_of_runs,
    output:
        "processed/{material}/dataset.parquet",
    log:
        "processed/logs/dataset-{material}.log",
    params:
        runs=folders_of_runs,
        lossy="--keep-lossy" if config["keep_lossy"] else "",
        code=fingerprint("pipeline.dataset"),
    message:
        "make the dataset of {wildcards.material}"
    shell:
        "exec python -m pipeline.dataset {params.runs:q} --processed processed --out {output:q} {params.lossy:q} > {log:q} 2>&1"
