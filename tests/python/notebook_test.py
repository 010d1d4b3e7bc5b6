"""Executes all cells of a notebook, and requires figures and no error.

    notebook_test.py NOTEBOOK        with the package on PYTHONPATH; exit code 77 (skipped) without Jupyter
"""

import pathlib
import sys
import tempfile

try:
    import ipykernel  # noqa: F401
    import matplotlib  # noqa: F401
    import nbformat
    import xarray  # noqa: F401
    from nbclient import NotebookClient
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

file = pathlib.Path(sys.argv[1])
notebook = nbformat.read(file, as_version=4)
nbformat.validate(notebook)
code = [cell for cell in notebook.cells if cell.cell_type == "code"]
assert all(not cell.outputs and cell.execution_count is None for cell in code), "it is kept without outputs"

with tempfile.TemporaryDirectory() as folder:
    # Use the interpreter of this test, not an installed kernel.
    client = NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": folder}})
    client.execute()

outputs = [output for cell in code for output in cell.outputs]
assert not any(output.output_type == "error" for output in outputs)
pictures = [output for output in outputs if "image/png" in output.get("data", {})]
assert len(pictures) >= 2, f"{len(pictures)} pictures"
print(f"{len(code)} cells, {len(pictures)} pictures")
