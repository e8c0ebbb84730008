#!/bin/sh
# Starts the program with the libraries, the units and the atlas of its archive.
folder=$(dirname -- "$(dirname -- "$(readlink -f -- "$0")")")
UDUNITS2_XML_PATH=${UDUNITS2_XML_PATH:-$folder/share/udunits/udunits2.xml}
PENDULAR_ATLAS=${PENDULAR_ATLAS:-$folder/share/pendular/atlas.csv}
export UDUNITS2_XML_PATH PENDULAR_ATLAS
exec "$folder/lib/loader" --inhibit-cache --library-path "$folder/lib" --argv0 pendular "$folder/lib/pendular" "$@"
