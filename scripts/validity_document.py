"""Parts of a document that are made: what stands between <!-- NAME --> and <!-- end of NAME -->."""


def replace_part(document, name, text):
    before = document.read_text()
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    if before.count(begin) != 1 or before.count(end) != 1:
        raise SystemExit(f"{document}: no {begin} .. {end}")
    head, rest = before.split(begin)
    tail = rest.split(end)[1]
    after = f"{head}{begin}\n{text}\n{end}{tail}"
    if after != before:
        document.write_text(after)
