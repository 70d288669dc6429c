# A run's frames read by VTK: read_by_vtk.py FOLDER. Exit 77: VTK's Python modules are not installed (python3-vtk9).
import json
import pathlib
import sys
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as error:
    print(f"skipped: {error} (Debian package python3-vtk9)")
    sys.exit(77)

VTK_TETRA = 10


def read(file):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    assert reader.GetErrorCode() == 0, f"{file}: VTK's error {reader.GetErrorCode()}"
    return reader.GetOutput()


folder = pathlib.Path(sys.argv[1])
statistics = json.loads((folder / "statistics.json").read_text())
frames = [folder / entry.get("file") for entry in xml.parse(folder / "frames.pvd").getroot().iter("DataSet")]
times = [float(entry.get("timestep")) for entry in xml.parse(folder / "frames.pvd").getroot().iter("DataSet")]
assert len(frames) > 2 and times == sorted(times), "frames in the order of time"

first, last = read(frames[0]), read(frames[-1])
assert first.GetNumberOfCells() == statistics["physical_particles"], (first.GetNumberOfCells(), statistics["physical_particles"])
assert last.GetNumberOfCells() == statistics["subdivided_particles"], (last.GetNumberOfCells(), statistics["subdivided_particles"])
assert all(last.GetCellType(i) == VTK_TETRA for i in range(last.GetNumberOfCells()))
data = last.GetCellData()
for name, components in {"stress": 6, "energy_density": 1, "fragment": 1, "body": 1, "material": 1, "parent": 1}.items():
    assert data.GetArray(name).GetNumberOfComponents() == components, name
fragments = {data.GetArray("fragment").GetValue(i) for i in range(last.GetNumberOfCells())}
assert len(fragments) == statistics["fragments"], (len(fragments), statistics["fragments"])
assert last.GetBounds()[4] < first.GetBounds()[4], "the body falls"
print(f"VTK reads {len(frames)} frames, {first.GetNumberOfCells()} to {last.GetNumberOfCells()} tets, {len(fragments)} fragments")
