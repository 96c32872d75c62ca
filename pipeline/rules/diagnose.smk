rule diagnose:
    input:
        recording,
    output:
        "reports/diagnosis/{run}/diagnosis.json",
        "reports/diagnosis/{run}/diagnosis.png",
    log:
        "processed/logs/diagnose-{run}.log",
    threads: 1
    params:
        code=fingerprint("pipeline.diagnose", "pipeline.diagnosis.*"),
    message:
        "diagnose {wildcards.run}"
    shell:
        "exec python -m pipeline.diagnose raw/{wildcards.run:q} --out reports/diagnosis > {log:q} 2>&1"
