# What ingest made of the recording; beside it, what the run is, and when it began.
def made_of_run(wildcards):
    stages = expand("processed/{run}/{stage}.parquet", run=wildcards.run, stage=["samples", "strokes"])
    return described([wildcards.run]) + stages


rule diagnose:
    input:
        made_of_run,
    output:
        directory("reports/diagnosis/{run}"),
    log:
        "processed/logs/diagnose-{run}.log",
    threads: 1
    resources:
        **NEEDS["diagnose"],
    params:
        content=content,
        mark=mark_of_run,
        code=fingerprint("pipeline.diagnose", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "diagnose {wildcards.run}"
    shell:
        "exec python -m pipeline.diagnose raw/{wildcards.run:q} --processed processed --out reports/diagnosis"
        " --note-refusals {params.mark:q} > {log:q} 2>&1"
