def recording(wildcards):
    return recorded_files(RAW, wildcards.run, SYNTHETIC)


rule ingest:
    input:
        recording,
    output:
        "processed/{run}/samples.parquet",
    log:
        "processed/logs/ingest-{run}.log",
    params:
        code=fingerprint("pipeline.ingest"),
    message:
        "ingest {wildcards.run}"
    shell:
        "exec python -m pipeline.ingest raw/{wildcards.run:q} --out {output:q} > {log:q} 2>&1"
