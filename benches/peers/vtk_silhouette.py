#!/usr/bin/env python3
"""Silhouette edges by VTK's vtkPolyDataSilhouette, on one core.

The filter is given the eye as its origin, with feature edges off and border edges on, and keeps its table of edges from
view to view. It yields lines, counted here. Not the same set as this workspace's: it takes every border edge, also those
of back faces, and evaluates signs in floating point.

Usage:
    pip install vtk numpy
    python3 vtk_silhouette.py MESH... [--views 200] [--output rows.jsonl]
"""

from extraction_rows import np, run

from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersHybrid import vtkPolyDataSilhouette


def prepare(positions, triangles):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions, deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles).ravel(), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    silhouette = vtkPolyDataSilhouette()
    silhouette.SetInputData(mesh)
    silhouette.SetDirectionToSpecifiedOrigin()
    silhouette.SetEnableFeatureAngle(0)
    silhouette.SetBorderEdges(1)

    def extract(eye):
        silhouette.SetOrigin(*eye)
        silhouette.Update()
        return silhouette.GetOutput().GetNumberOfLines()

    return extract, None


if __name__ == "__main__":
    run("vtk", {"vtkPolyDataSilhouette": prepare})
