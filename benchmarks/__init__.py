"""What lommel costs and how exact it is, beside the FFT, memory itself, plain NumPy and other packages."""
