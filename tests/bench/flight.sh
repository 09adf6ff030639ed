#!/usr/bin/env bash
# Flights over terrain in tiles: BENCH TALUS FOLDER. Over a billion samples, generated, 1 m apart, without a photo and under one of as many
# texels; over a mosaic of 39 tiles that are cut from the real files of TALUS_DATA, 30 m and 10 m apart, that overlap and leave a hole;
# and the same way over 4096, 16384 and 65536 samples a side, with so little memory for reading that the smallest fills it. What is
# in the folder already is used again: it takes 19 GB and forty minutes to make. Needs GDAL's programs.
set -euo pipefail
bench=$(realpath "$1")
talus=$(realpath "$2")
[ -z "${TALUS_DATA:-}" ] || TALUS_DATA=$(realpath "$TALUS_DATA")
mkdir -p "$3"
cd "$3"
export LIBGL_ALWAYS_SOFTWARE=${LIBGL_ALWAYS_SOFTWARE:-1}

[ -e made.tif ] || "$talus" tile --generate mountains,32768x32768 --spacing 1 made.tif 2>/dev/null
"$bench" flight made.tif
if [ ! -e photo.tif ]; then
    printf '%s\n' "0 40 90 160" "200 70 110 50" "700 150 140 90" "1300 120 100 90" "2000 240 240 245" >colours.txt
    gdaldem color-relief -q -of VRT made.tif colours.txt photo.vrt
    "$talus" tile --texture photo.vrt photo.tif 2>/dev/null
fi
"$bench" flight made.tif --photo photo.tif

if [ -n "${TALUS_DATA:-}" ]; then
    mkdir -p parts
    # The second one lies east of the first.
    cut() { # FILE SPACING ORIGIN_X ORIGIN_Y COLUMNS ROWS NAME
        local size width height
        size=$(gdalinfo "$1" | sed -n 's/^Size is //p')
        width=${size%,*}
        height=${size#*, }
        for row in $(seq 0 $(($6 - 1))); do
            for column in $(seq 0 $(($5 - 1))); do
                [ "$7$row$column" = b12 ] && continue # the hole
                local x=$((column * width / $5)) y=$((row * height / $6))
                local w=$((width / $5 + 5)) h=$((height / $6 + 5))
                [ $((x + w)) -le "$width" ] || w=$((width - x))
                [ $((y + h)) -le "$height" ] || h=$((height - y))
                gdal_translate -q -srcwin $x $y $w $h -a_ullr $(($3 + 30 * x)) $(($4 - 30 * y)) $(($3 + 30 * (x + w))) \
                    $(($4 - 30 * (y + h))) -a_srs EPSG:32611 -a_nodata -32768 -ot Float32 "$1" part.tif
                gdalwarp -q -overwrite -tr "$2" "$2" -r bilinear part.tif "parts/$7$row$column.tif"
            done
        done
    }
    cut "$TALUS_DATA/bigtujunga_30m_1197x643.tif" 30 0 40000 5 4 a
    cut "$TALUS_DATA/santa_ynez_coast_30m_1537.tif" 10 36000 40000 5 4 b
    gdalbuildvrt -q -overwrite -resolution highest mosaic.vrt parts/*.tif
    rm -f mosaic.tif*
    "$talus" tile mosaic.vrt mosaic.tif 2>/dev/null
    "$bench" flight mosaic.tif
fi

# The same ground at the same place, of ever larger terrain.
[ -e m16384.tif ] || "$talus" tile --generate mountains,16384x16384 --spacing 1 m16384.tif 2>/dev/null
if [ ! -e m4096.tif ]; then
    gdal_translate -q -srcwin 8000 8000 4096 4096 m16384.tif crop.tif
    "$talus" tile crop.tif m4096.tif 2>/dev/null
fi
if [ ! -e m65536.tif ]; then
    # Mirrored copies meet without a step, which no coarse level could show.
    flip() { # NAME LEFT TOP RIGHT BOTTOM: the same samples from there to there
        gdal_translate -q -of VRT -a_ullr "$2" "$3" "$4" "$5" m16384.tif "$1.vrt"
        gdalwarp -q -overwrite -te 0 0 16384 16384 -ts 16384 16384 -r near -co TILED=YES -co COMPRESS=ZSTD "$1.vrt" "$1.tif"
    }
    flip flipped1 16384 16384 0 0
    flip flipped2 0 0 16384 16384
    flip flipped3 16384 0 0 16384
    ln -sf m16384.tif flipped0.tif
    {
        echo '<VRTDataset rasterXSize="65536" rasterYSize="65536"><GeoTransform>0,1,0,65536,0,-1</GeoTransform><VRTRasterBand dataType="Float32" band="1">'
        for y in 0 1 2 3; do
            for x in 0 1 2 3; do
                echo "<SimpleSource><SourceFilename relativeToVRT='1'>flipped$((x % 2 + 2 * (y % 2))).tif</SourceFilename><SourceBand>1</SourceBand>"
                echo "<SrcRect xOff='0' yOff='0' xSize='16384' ySize='16384'/>"
                echo "<DstRect xOff='$((16384 * x))' yOff='$((16384 * y))' xSize='16384' ySize='16384'/></SimpleSource>"
            done
        done
        echo '</VRTRasterBand></VRTDataset>'
    } >copies.vrt
    "$talus" tile copies.vrt m65536.tif 2>/dev/null
fi
# Column and row 10048 of the second: east and north of the south-west sample, m.
"$bench" flight m4096.tif --host-mib 64 --extent 2000 --middle 2048,2047
"$bench" flight m16384.tif --host-mib 64 --extent 2000 --middle 10048,6335
"$bench" flight m65536.tif --host-mib 64 --extent 2000 --middle 42816,22719
