from pipeline.proof.plan import batches, written

BATCHES = batches(config["proof"])
PROOF = "processed/proof"
PROOF_TABLES = ["authors", "laws", "cases", "sizes", "scores", "beside"]
PROOF_FILES = (
    [f"{table}.csv" for table in PROOF_TABLES]
    + ["proof.md", "sizes.png"]
    + expand("{figure}.{suffix}", figure=("confusion", "dose_response"), suffix=("png", "pdf"))
)


def cases_of(wildcards):
    return written(BATCHES[wildcards.batch])


def compared(batch):
    return [case.run for case in BATCHES[batch] if case.baselines]


def compared_of(wildcards):
    return compared(wildcards.batch)


def code_of_concealed(wildcards):
    author = BATCHES[wildcards.batch][0].author
    return fingerprint(
        "pipeline.proof.conceal_batch", f"pipeline.rig.authors.{author}.*" if author else "pipeline.rig.effects.*"
    )


def without(wildcards):
    return wildcards.batch.removeprefix("without-") if wildcards.batch.startswith("without-") else ""


def author(wildcards):
    """Whose cases these are: they are judged by who was not taught by this author."""
    return BATCHES[wildcards.batch][0].author


# What is hidden goes two ways: the recordings to whoever diagnoses, the answers to the score alone.
rule conceal_batch:
    output:
        runs=directory(f"{PROOF}/concealed/{{batch}}"),
        answers=f"{PROOF}/sealed/{{batch}}.json",
    log:
        f"{PROOF}/logs/conceal_batch-{{batch}}.log",
    resources:
        **NEEDS["conceal_batch"],
    params:
        cases=cases_of,
        code=code_of_concealed,
    message:
        "conceal {wildcards.batch}"
    shell:
        "exec python -m pipeline.proof.conceal_batch --cases {params.cases:q}"
        " --runs {output.runs:q} --answers {output.answers:q} > {log:q} 2>&1"


rule verdicts:
    input:
        f"{PROOF}/concealed/{{batch}}",
    output:
        directory(f"{PROOF}/verdicts/{{batch}}"),
    log:
        f"{PROOF}/logs/verdicts-{{batch}}.log",
    resources:
        **NEEDS["verdicts"],
    params:
        without=without,
        author=author,
        code=fingerprint("pipeline.proof.verdicts", "pipeline.diagnose", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "diagnose {wildcards.batch}"
    shell:
        "exec python -m pipeline.proof.verdicts {input:q} --out {output:q} --without={params.without:q}"
        " --untaught-by={params.author:q} > {log:q} 2>&1"


rule carry_on:
    input:
        f"{PROOF}/verdicts/{{batch}}",
    output:
        directory(f"{PROOF}/carried_on/{{batch}}"),
    log:
        f"{PROOF}/logs/carry_on-{{batch}}.log",
    resources:
        **NEEDS["carry_on"],
    params:
        cases=cases_of,
        code=fingerprint("pipeline.proof.carry_on", "pipeline.rig.effects.*"),
    message:
        "carry out what the ties of {wildcards.batch} ask for"
    shell:
        "exec python -m pipeline.proof.carry_on --cases {params.cases:q} --verdicts {input:q} --out {output:q} > {log:q} 2>&1"


rule settle:
    input:
        runs=f"{PROOF}/concealed/{{batch}}",
        carried_on=f"{PROOF}/carried_on/{{batch}}",
    output:
        directory(f"{PROOF}/settled/{{batch}}"),
    log:
        f"{PROOF}/logs/settle-{{batch}}.log",
    resources:
        **NEEDS["settle"],
    params:
        without=without,
        code=fingerprint("pipeline.proof.settle", "pipeline.diagnose", "pipeline.diagnosis.*", "pipeline.systems.*"),
    message:
        "diagnose the ties of {wildcards.batch} again"
    shell:
        "exec python -m pipeline.proof.settle --runs {input.runs:q} --more {input.carried_on:q} --out {output:q}"
        " --without={params.without:q} > {log:q} 2>&1"


rule lookalikes:
    input:
        f"{PROOF}/verdicts/{{batch}}",
    output:
        f"{PROOF}/lookalikes/{{batch}}.json",
    log:
        f"{PROOF}/logs/lookalikes-{{batch}}.log",
    resources:
        **NEEDS["lookalikes"],
    params:
        cases=cases_of,
        code=fingerprint("pipeline.proof.lookalikes", "pipeline.rig.effects.*"),
    message:
        "ask the rig what can look like what in {wildcards.batch}"
    shell:
        "exec python -m pipeline.proof.lookalikes --cases {params.cases:q} --verdicts {input:q} --out {output:q}"
        " > {log:q} 2>&1"


rule ask_baselines:
    input:
        f"{PROOF}/concealed/{{batch}}",
    output:
        directory(f"{PROOF}/baselines/{{batch}}"),
    log:
        f"{PROOF}/logs/ask_baselines-{{batch}}.log",
    resources:
        **NEEDS["ask_baselines"],
    params:
        runs=compared_of,
        code=fingerprint("pipeline.proof.ask_baselines", "pipeline.proof.baselines.*"),
    message:
        "ask the baselines about {wildcards.batch}"
    shell:
        "exec python -m pipeline.proof.ask_baselines {params.runs:q} --runs {input:q} --out {output:q} > {log:q} 2>&1"


rule twins:
    output:
        "reports/proof/twins.csv",
    log:
        f"{PROOF}/logs/twins.log",
    resources:
        **NEEDS["twins"],
    params:
        effects=[f"--effect={name}" for name in config["proof"].get("twins", [])],
        code=fingerprint("pipeline.proof.twins", "pipeline.rig.effects.*", "pipeline.diagnosis.*"),
    message:
        "measure what the library's twins leave of the rig's effects"
    shell:
        "exec python -m pipeline.proof.twins {params.effects:q} --out {output:q} > {log:q} 2>&1"


# The only rule that opens the answers, and it runs when the last verdict is written.
rule score:
    input:
        expand(PROOF + "/concealed/{batch}", batch=BATCHES),
        expand(PROOF + "/verdicts/{batch}", batch=BATCHES),
        expand(PROOF + "/settled/{batch}", batch=BATCHES),
        expand(PROOF + "/lookalikes/{batch}.json", batch=BATCHES),
        expand(PROOF + "/baselines/{batch}", batch=filter(compared, BATCHES)),
        expand(PROOF + "/sealed/{batch}.json", batch=BATCHES),
        twins="reports/proof/twins.csv",
    output:
        expand("reports/proof/{file}", file=PROOF_FILES),
    log:
        f"{PROOF}/logs/score.log",
    resources:
        **NEEDS["score"],
    params:
        batches=list(BATCHES),
        note=note_of(mark_of("proof")),
        code=fingerprint("pipeline.proof.score", "pipeline.rig.effects.*"),
    message:
        "open the answers and score the verdicts"
    shell:
        "exec python -m pipeline.proof.score {params.batches:q} --place processed/proof --twins {input.twins:q}"
        " --note={params.note:q} --out reports/proof > {log:q} 2>&1"


rule proof_page:
    input:
        expand("reports/proof/{file}", file=PROOF_FILES),
    output:
        "reports/proof/proof.html",
        expand("reports/proof/{table}.csv-metadata.json", table=PROOF_TABLES),
    log:
        f"{PROOF}/logs/proof_page.log",
    resources:
        **NEEDS["proof_page"],
    params:
        made_by=mark_of("proof"),
        code=fingerprint("pipeline.report.proof", "pipeline.report.web.*"),
    message:
        "write the page of the proof"
    shell:
        "exec python -m pipeline.report.proof reports/proof --made-by {params.made_by:q} > {log:q} 2>&1"
