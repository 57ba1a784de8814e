"""Reads series of a VTK folder with ParaView and writes what it saw as JSON. Run by pvpython: FOLDER OUTPUT SERIES..."""
import json
import sys

from paraview import servermanager
from paraview.simple import OpenDataFile

folder, output = sys.argv[1], sys.argv[2]


def arrays(attributes):
    seen = {}
    for k in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(k)
        values = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
        seen[array.GetName()] = values
    return seen


result = {}
for series in sys.argv[3:]:
    reader = OpenDataFile(f"{folder}/{series}.pvd")
    reader.UpdatePipelineInformation()
    instants = []
    for time in reader.TimestepValues:
        reader.UpdatePipeline(time)
        data = servermanager.Fetch(reader)
        lines = []
        for i in range(data.GetNumberOfCells()):
            cell = data.GetCell(i)
            lines.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
        instants.append({
            "time": time,
            "points": [data.GetPoint(i) for i in range(data.GetNumberOfPoints())],
            "cells": lines,
            "point_arrays": arrays(data.GetPointData()),
            "cell_arrays": arrays(data.GetCellData()),
        })
    result[series] = instants
with open(output, "w") as file:
    json.dump(result, file)
