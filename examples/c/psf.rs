// PSFs from Rust, without a build script: rustc -O -L PREFIX/lib -C link-arg=-Wl,-rpath,PREFIX/lib psf.rs
use std::ffi::{c_char, c_int, CStr};

#[repr(C)]
pub struct RawPlan {
    _opaque: [u8; 0],
}

#[link(name = "lommel")]
extern "C" {
    fn lommel_message() -> *const c_char;
    fn lommel_plan_new(height: i32, width: i32, pixel: f64, tol: f64) -> *mut RawPlan;
    fn lommel_plan_free(plan: *mut RawPlan);
    fn lommel_plan_normalize(plan: *mut RawPlan, normalize: c_int) -> c_int;
    fn lommel_psf_zernike(
        plan: *const RawPlan, pupils: i32, terms: i32, n: *const i32, m: *const i32, coefficients: *const f64,
        images: *mut f64, bounds: *mut f64,
    ) -> c_int;
}

const STREHL: c_int = 1;

/// A term: n, m and its coefficient in radians at the edge of the pupil.
pub type Term = (i32, i32, f64);

fn checked(code: c_int) -> Result<(), String> {
    match code {
        0 => Ok(()),
        _ => Err(unsafe { CStr::from_ptr(lommel_message()) }.to_string_lossy().into_owned()),
    }
}

/// A window of pixels and a tolerance; PSFs are relative to the peak without aberration.
pub struct Plan {
    raw: *mut RawPlan,
    pixels: usize,
}

impl Plan {
    pub fn new(height: i32, width: i32, pixel: f64, tol: f64) -> Result<Self, String> {
        let raw = unsafe { lommel_plan_new(height, width, pixel, tol) };
        if raw.is_null() {
            return Err(checked(1).unwrap_err());
        }
        let plan = Plan { raw, pixels: height as usize * width as usize };
        checked(unsafe { lommel_plan_normalize(raw, STREHL) })?;
        Ok(plan)
    }

    /// The image, row by row, and the bound on its error, relative to the peak.
    pub fn psf(&self, terms: &[Term]) -> Result<(Vec<f64>, f64), String> {
        let n: Vec<i32> = terms.iter().map(|term| term.0).collect();
        let m: Vec<i32> = terms.iter().map(|term| term.1).collect();
        let edge: Vec<f64> = terms.iter().map(|term| term.2).collect();
        let (mut image, mut bound) = (vec![0.0; self.pixels], 0.0);
        checked(unsafe {
            lommel_psf_zernike(
                self.raw, 1, terms.len() as i32, n.as_ptr(), m.as_ptr(), edge.as_ptr(), image.as_mut_ptr(), &mut bound,
            )
        })?;
        Ok((image, bound))
    }
}

impl Drop for Plan {
    fn drop(&mut self) {
        unsafe { lommel_plan_free(self.raw) }
    }
}

fn main() -> Result<(), String> {
    let plan = Plan::new(65, 65, 0.25, 1e-8)?;
    let (image, bound) = plan.psf(&[(2, 0, 0.5), (3, 1, 0.8)])?;
    println!("largest value {:.6}, bound {:.1e}", image.iter().cloned().fold(0.0, f64::max), bound);
    println!("{}", plan.psf(&[(2, 1, 0.5)]).unwrap_err());
    Ok(())
}
