#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the small wind files beside it: one field in many formats, by the formats' own descriptions."""
import struct,zlib,base64
P=[(i,j,k) for k in range(2) for j in range(2) for i in range(3)]
V=[(1+i,0.5*j,0.25*k) for i,j,k in P]
txt=''.join('%g %g %g\n'%v for v in V)
be=b''.join(struct.pack('>3f',*v) for v in V)
head='# vtk DataFile Version 3.0\nsmall wind\n%s\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 100 200 5\nSPACING 10 20 5\nPOINT_DATA 12\n'
open('vectors.vtk','w').write(head%'ASCII'+'SCALARS p float 1\nLOOKUP_TABLE default\n'+'0 '*12+'\nVECTORS wind float\n'+txt)
open('field.vtk','w').write(head%'ASCII'+'FIELD attributes 2\np 1 12 float\n'+'0 '*12+'\nU 3 12 double\n'+txt)
open('binary.vtk','wb').write((head%'BINARY').encode()+b'SCALARS p float\nLOOKUP_TABLE default\n'+struct.pack('>12f',*range(12))+b'\nVECTORS wind float\n'+be+b'\n')
# As VTK 9 writes: field data first, cell data before point data, metadata behind arrays, big-endian binary.
META='\nMETADATA\nCOMPONENT_NAMES\nX\nY\nZ\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 1 3.05164 \n\n'
START='# vtk DataFile Version 5.1\nvtk output\n%s\nDATASET %s\n'
IMAGE='DIMENSIONS 3 2 2\nSPACING 10 20 5\nORIGIN 100 200 5\n'
open('paraview.vtk','w').write(START%('ASCII','STRUCTURED_POINTS')+'FIELD FieldData 2\nTimeValue 1 1 double\n42.5 \nsolver 1 2 string\nby%20hand\n\n\n'
    +IMAGE+'CELL_DATA 2\nSCALARS id int\nLOOKUP_TABLE default\n0 1 \nPOINT_DATA 12\nSCALARS p float\nLOOKUP_TABLE default\n'+'0 '*12
    +'\nFIELD FieldData 3\nbits 1 12 bit\n'+'0 1 '*6+'\nT 1 12 float\n'+'1 '*12+'\nMETADATA\nINFORMATION 0\n\nU 3 12 double\n'+txt+META)
bed=b''.join(struct.pack('>3d',*v) for v in V)
open('paraviewbinary.vtk','wb').write((START%('BINARY','STRUCTURED_POINTS')+'FIELD FieldData 2\nTimeValue 1 1 double\n').encode()+struct.pack('>d',42.5)
    +b'\nsolver 1 2 string\n\xc7by\nhand\x80\x03two\n'+IMAGE.encode()+b'CELL_DATA 2\nCOLOR_SCALARS c 3\n\1\2\3\4\5\6\nPOINT_DATA 12\nFIELD FieldData 2\nbits 1 12 bit\nUP\nids 1 12 vtkIdType\n'
    +struct.pack('>12i',*range(12))+b'\nVECTORS wind double\n'+bed+META.encode())
open('cells.vtk','w').write(START%('ASCII','STRUCTURED_POINTS')+'DIMENSIONS 4 3 3\nASPECT_RATIO 10 20 5\nORIGIN 95 190 2.5\nCELL_DATA 12\nVECTORS wind float\n'+txt+META)
open('rectilinear.vtk','w').write(START%('ASCII','RECTILINEAR_GRID')+'DIMENSIONS 3 2 2\nX_COORDINATES 3 double\n100 110 120\nY_COORDINATES 2 float\n200 220\nZ_COORDINATES 2 float\n5 10\nPOINT_DATA 12\nVECTORS wind float\n'+txt+META)
open('structured.vtk','w').write(START%('ASCII','STRUCTURED_GRID')+'DIMENSIONS 3 2 2\nPOINTS 12 float\n'
    +''.join('%g %g %g\n'%(100+10*i,200+20*j,5+5*k) for i,j,k in P)+'POINT_DATA 12\nVECTORS wind float\n'+txt+META)
le=b''.join(struct.pack('<3f',*v) for v in V)
led=b''.join(struct.pack('<3d',*v) for v in V)
def vti(attrs,arr,app=b'',point='PointData'):
    return ('<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" %s>\n<ImageData WholeExtent="0 2 0 1 0 1" Origin="100 200 5" Spacing="10 20 5">\n<Piece Extent="0 2 0 1 0 1">\n<PointData Vectors="wind">\n<DataArray type="Float32" Name="other" NumberOfComponents="3" format="ascii">%s</DataArray>\n%s\n</PointData>\n</Piece>\n</ImageData>\n'%(attrs,'9 '*36,arr)).encode()+app+b'</VTKFile>\n'
D='<DataArray type="Float%d" Name="wind" NumberOfComponents="3" format="%s"%s>%s</DataArray>'
L='byte_order="LittleEndian"'
open('ascii.vti','wb').write(vti(L,D%(32,'ascii','',txt)))
open('base64.vti','wb').write(vti(L,D%(32,'binary','',base64.b64encode(struct.pack('<I',len(le))+le).decode())))
def blocks(raw,bs,fmt):
    n=(len(raw)+bs-1)//bs; last=len(raw)%bs
    z=[zlib.compress(raw[i*bs:(i+1)*bs]) for i in range(n)]
    return struct.pack('<%d%s'%(3+n,fmt),n,bs,last,*map(len,z)), b''.join(z)
h,z=blocks(le,60,'I')
open('zlib.vti','wb').write(vti(L+' compressor="vtkZLibDataCompressor"',D%(32,'binary','',(base64.b64encode(h)+base64.b64encode(z)).decode())))
app=struct.pack('<Q',len(le))+le
open('raw.vti','wb').write(vti(L+' header_type="UInt64"',D%(32,'appended',' offset="0"',''),b'<AppendedData encoding="raw">\n_'+app+b'\n</AppendedData>\n'))
h,z=blocks(led,1000,'Q')
open('rawzlib.vti','wb').write(vti(L+' header_type="UInt64" compressor="vtkZLibDataCompressor"',D%(64,'appended',' offset="7"',''),b'<AppendedData encoding="raw">\n_1234567'+h+z+b'\n</AppendedData>\n'))
beh=struct.pack('>I',len(be))+be
open('bigendian.vti','wb').write(vti('byte_order="BigEndian"',D%(32,'appended',' offset="0"',''),b'<AppendedData encoding="base64">\n_'+base64.b64encode(beh)+b'\n</AppendedData>\n'))
# TurbSim: 3 across, 2 up, 4 times, 1 tower point; u = 8 + t index, v = y/10, w = z/100
slope=(100.,200.,300.); off=(-500.,20.,0.)
b=struct.pack('<hiiii6f',7,2,3,1,4,10.,5.,.5,8.,20.,15.)
for s,o in zip(slope,off): b+=struct.pack('<ff',s,o)
d=b'small'
b+=struct.pack('<i',len(d))+d
for t in range(4):
    for z in range(2):
        for y in range(3):
            v=(8+t,(y-1)*5/10,(15+10*z)/100)
            b+=struct.pack('<3h',*[round(x*s+o) for x,s,o in zip(v,slope,off)])
    b+=struct.pack('<3h',1,2,3)
open('small.bts','wb').write(b)
open('toa5.dat','w').write('"TOA5","1","CR3000","1","OS","prog","1","table"\n"TIMESTAMP","RECORD","Ux","Uy","Uz"\n"TS","RN","m/s","m/s","m/s"\n"","","Smp","Smp","Smp"\n"2020-01-01 00:00:00.5",1,1,2,0.5\n"2020-01-01 00:00:01",2,"NAN",2,0.5\n"2020-01-01 00:00:02.5",3,5,-2,0.25\n')
open('pair_vel.asc','w').write('ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -999\n4 5 6\n1 2 -999\n')
open('pair_ang.asc','w').write('NCOLS 3\nNROWS 2\nXLLCENTER 105\nYLLCENTER 205\nCELLSIZE 10\nnodata_value -999\n0 90 180\n270 270 -999\n')
open('table.csv','w').write('time,speed,direction\n0,36,270\n10,18,180\n')
