#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes wrf_lambert.nc and wrf_polar.nc beside it: the least of WRF output, its latitudes and longitudes by
the closed forms of the maps on the sphere (Snyder 1987). Needs ncgen."""
import subprocess
from math import atan, atan2, cos, degrees, hypot, log, pi, radians, sin, tan

R = 6370000.0
STAND_LON = 10.0


def lambert(x, y, first=30.0, second=60.0, middle=45.0):
    """Latitude and longitude of a place on the map, metres."""
    half = lambda latitude: tan(pi / 4 + radians(latitude) / 2)
    n = log(cos(radians(first)) / cos(radians(second))) / log(half(second) / half(first))
    f = cos(radians(first)) * half(first) ** n / n
    below = R * f / half(middle) ** n
    return (degrees(2 * atan((R * f / hypot(x, below - y)) ** (1 / n)) - pi / 2),
            STAND_LON + degrees(atan2(x, below - y)) / n)


def polar(x, y, first=-70.0):
    """The same around the South Pole."""
    scale = R * (1 + sin(radians(-first)))
    return -degrees(pi / 2 - 2 * atan(hypot(x, y) / scale)), STAND_LON + degrees(atan2(x, y))


def write(name, place, attributes, corners, size=(4, 3), cell=9000.0):
    """One layer of 4 x 3 cells; u tells the column and v the row of the cell, each time 100 more."""
    nx, ny = size
    steps = range(len(corners))
    text = lambda numbers: ', '.join(repr(number) for number in numbers)
    points = [place(x0 + i * cell, y0 + j * cell) for x0, y0 in corners for j in range(ny) for i in range(nx)]
    u = [100.0 * t + i - 0.5 for t in steps for j in range(ny) for i in range(nx + 1)]
    v = [100.0 * t + j - 0.5 for t in steps for j in range(ny + 1) for i in range(nx)]
    ground = [9.81 * 20 * k for t in steps for k in range(2) for _ in range(nx * ny)]
    cdl = f'''netcdf {name} {{
dimensions: Time = {len(corners)} ; bottom_top = 1 ; bottom_top_stag = 2 ; south_north = {ny} ; south_north_stag = {ny + 1} ;
 west_east = {nx} ; west_east_stag = {nx + 1} ;
variables:
 float XTIME(Time) ; XTIME:units = "minutes since 2020-01-01 00:00:00" ;
 float XLAT(Time, south_north, west_east) ; float XLONG(Time, south_north, west_east) ;
 float U(Time, bottom_top, south_north, west_east_stag) ; U:units = "m s-1" ;
 float V(Time, bottom_top, south_north_stag, west_east) ; V:units = "m s-1" ;
 float W(Time, bottom_top_stag, south_north, west_east) ; W:units = "m s-1" ;
 float PH(Time, bottom_top_stag, south_north, west_east) ; float PHB(Time, bottom_top_stag, south_north, west_east) ;
 :DX = {cell}f ; :DY = {cell}f ; :STAND_LON = {STAND_LON}f ; {attributes}
data:
 XTIME = {text(60.0 * t for t in steps)} ;
 XLAT = {text(latitude for latitude, _ in points)} ;
 XLONG = {text(longitude for _, longitude in points)} ;
 U = {text(u)} ; V = {text(v)} ; W = {text(0.0 for _ in ground)} ;
 PH = {text(0.0 for _ in ground)} ; PHB = {text(ground)} ;
}}
'''
    subprocess.run(['ncgen', '-3', '-o', name + '.nc'], input=cdl, text=True, check=True)


write('wrf_lambert', lambert, ':MAP_PROJ = 1 ; :TRUELAT1 = 30.f ; :TRUELAT2 = 60.f ; :MOAD_CEN_LAT = 45.f ;',
      [(-500000.0, 20000.0), (-491000.0, 38000.0)])  # one cell east and two north
write('wrf_polar', polar, ':MAP_PROJ = 2 ; :TRUELAT1 = -70.f ;', [(-300000.0, 1200000.0)])
