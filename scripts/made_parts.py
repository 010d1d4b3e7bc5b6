"""Parts of a document that are made: what stands between <!-- NAME --> and <!-- end of NAME -->."""


def replace_part(document, name, text, check=False):
    """With `check` nothing is written, and a part that would change is an error."""
    before = document.read_text()
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    if before.count(begin) != 1 or before.count(end) != 1:
        raise SystemExit(f"{document}: no {begin} .. {end}")
    head, rest = before.split(begin)
    tail = rest.split(end)[1]
    after = f"{head}{begin}\n{text}\n{end}{tail}"
    if check and after != before:
        raise SystemExit(f"{document}: {name} is not what its script makes (run it again)")
    if after != before:
        document.write_text(after)
