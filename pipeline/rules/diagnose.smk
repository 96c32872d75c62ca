rule diagnose:
    input:
        recording,
    output:
        directory("reports/diagnosis/{run}"),
    log:
        "processed/logs/diagnose-{run}.log",
    threads: 1
    resources:
        **NEEDS["diagnose"],
    params:
        content=content,
        code=fingerprint("pipeline.diagnose", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "diagnose {wildcards.run}"
    shell:
        "exec python -m pipeline.diagnose raw/{wildcards.run:q} --out reports/diagnosis --note-refusals > {log:q} 2>&1"
