"""Generated parts of a document, between <!-- NAME --> and <!-- end of NAME -->."""


def replace_part(document, name, text, check=False):
    """Replaces the part `name` by the text. With `check`, writes nothing and fails if the part would change."""
    before = document.read_text()
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    if before.count(begin) != 1 or before.count(end) != 1:
        raise SystemExit(f"{document}: {begin} .. {end} must occur once")
    head, rest = before.split(begin)
    tail = rest.split(end)[1]
    after = f"{head}{begin}\n{text}\n{end}{tail}"
    if check and after != before:
        raise SystemExit(f"{document}: part {name} is out of date; run its script again")
    if after != before:
        document.write_text(after)
