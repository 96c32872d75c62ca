# What the workflow says when it starts, fails and ends.
onstart:
    for run in PLAN.unfinished:
        print(f"raw/{run}: left out, its recording is unfinished (python -m pipeline.capture --recover raw/{run})")


onerror:
    print(summary(Path("reports"), MATERIALS, DIAGNOSED))
    print("Not all was made: see the errors above. What other runs need is made with --keep-going.")


onsuccess:
    print(summary(Path("reports"), MATERIALS, DIAGNOSED))
    if Path("reports/proof/proof.md").is_file():
        print("the concealed proof: reports/proof/proof.md")
    if Path("reports/real/index.html").is_file():
        print("public rigs: reports/real/index.html")
