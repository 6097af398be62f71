# What `make photo` runs after motorcycle.py, which writes the photograph and its depth to out. Where the depth is unknown, it is
# that of the nearest point.
set -eux
lens=examples/motorcycle.toml
set -- out/motorcycle-depth.tif "$lens" --missing nearest
lommel blur out/motorcycle.png "$@" --focus 2.4m --output out/motorcycle-near.png
lommel blur out/motorcycle.png "$@" --focus 4.8m --output out/motorcycle-far.png
lommel blur out/motorcycle.png "$@" --focus 2.2m --focus-to 4.8m --frames 6 --tol 1e-3 --output out/motorcycle-pull.webp
lommel restore out/motorcycle-near.png "$@" --focus 2.4m --white 50000 --read 3 --output out/motorcycle-restored.png
lommel depth out/motorcycle-near.png out/motorcycle-far.png "$lens" --focus 2.4m --focus 4.8m --between 2m 5.2m \
	--white 50000 --read 3 --output out/motorcycle-found.tif --plot out/motorcycle-found.png
