# A recording goes stale by its content, not by its time; one that a rule makes, when that rule runs. Everything stands
# on recordings, so whoever plans comes by here and learns which files are to be made again whatever their times say.
def recording(wildcards):
    workflow.dag.forcefiles.update(AGAIN)
    files = recorded_files(RAW, wildcards.run, SYNTHETIC)
    return files if wildcards.run in SYNTHETIC else ancient(files)


def content(wildcards):
    return "" if wildcards.run in SYNTHETIC else CONTENT[wildcards.run]


rule ingest:
    input:
        recording,
    output:
        "processed/{run}/samples.parquet",
    log:
        "processed/logs/ingest-{run}.log",
    params:
        content=content,
        code=fingerprint("pipeline.stages.ingest"),
    message:
        "ingest {wildcards.run}"
    shell:
        "exec python -m pipeline.stages.ingest raw/{wildcards.run:q} --out {output:q} $NOTE_REFUSALS > {log:q} 2>&1"
