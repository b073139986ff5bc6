! The rotating chain of two links, as TwoLinkChain of include/equilibria/mechanisms/rotating_chain.hpp, ratio r = 1.5: the
! equations (3.2) of Baillieul, the second one divided by alpha r. PAR(1) is omega, PAR(2) alpha.
! Lines that end with "derivatives" are for JAC = 1.
SUBROUTINE FUNC(NDIM, U, ICP, PAR, IJAC, F, DFDU, DFDP)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), IJAC
  DOUBLE PRECISION, INTENT(IN) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(OUT) :: F(NDIM)
  DOUBLE PRECISION, INTENT(INOUT) :: DFDU(NDIM, NDIM), DFDP(NDIM, *)
  DOUBLE PRECISION, PARAMETER :: R = 1.5d0
  DOUBLE PRECISION :: S(2), C(2), X, Y, W, A
  W = PAR(1)
  A = PAR(2)
  S = SIN(U)
  C = COS(U)
  X = S(1) + A*R*S(2)
  Y = S(1) + R*S(2)
  F(1) = S(1) - W**2*C(1)*X
  F(2) = S(2) - W**2*C(2)*Y
  IF (IJAC == 0) RETURN ! derivatives
  DFDU(1, 1) = C(1) + W**2*(S(1)*X - C(1)**2) ! derivatives
  DFDU(1, 2) = -W**2*C(1)*A*R*C(2) ! derivatives
  DFDU(2, 1) = -W**2*C(2)*C(1) ! derivatives
  DFDU(2, 2) = C(2) + W**2*(S(2)*Y - R*C(2)**2) ! derivatives
  IF (IJAC == 1) RETURN ! derivatives
  DFDP(1, 1) = -2*W*C(1)*X ! derivatives
  DFDP(2, 1) = -2*W*C(2)*Y ! derivatives
  DFDP(1, 2) = -W**2*C(1)*R*S(2) ! derivatives
  DFDP(2, 2) = 0 ! derivatives
END SUBROUTINE FUNC

! An equilibrium near the fold that the cusp lies on: no branch from U = 0 at this alpha leads to that fold.
SUBROUTINE STPNT(NDIM, U, PAR, T)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  DOUBLE PRECISION, INTENT(INOUT) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(IN) :: T
  PAR(1:2) = (/ 3.d0, 0.4d0 /)
  U = (/ 1.280620045175075d0, -1.355068671266821d0 /)
END SUBROUTINE STPNT

SUBROUTINE BCND
END SUBROUTINE BCND
SUBROUTINE ICND
END SUBROUTINE ICND
SUBROUTINE FOPT
END SUBROUTINE FOPT
SUBROUTINE PVLS
END SUBROUTINE PVLS
