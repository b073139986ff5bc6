! The star dome of 24 bars, as support::star_dome of programs/support/structures.hpp: EA = 1, Green strain, loads 1 on the
! ring and 0.5 on the apex. PAR(1) is P / EA in thousandths: of the size of the displacements.
! Lines that end with "derivatives" are for JAC = 1.
MODULE DOME
  IMPLICIT NONE
  DOUBLE PRECISION :: NODES(3, 13)
  INTEGER :: BARS(2, 24)
CONTAINS
  SUBROUTINE BUILD
    DOUBLE PRECISION, PARAMETER :: PI = ACOS(-1.d0)
    INTEGER :: K
    NODES(:, 1) = (/ 0.d0, 0.d0, 8.216d0 /)
    DO K = 0, 5
      NODES(:, 2 + K) = (/ 25*COS(K*PI/3), 25*SIN(K*PI/3), 6.216d0 /)
      NODES(:, 8 + K) = (/ 50*COS(K*PI/3 + PI/6), 50*SIN(K*PI/3 + PI/6), 0.d0 /)
      BARS(:, 4*K + 1) = (/ 1, 2 + K /)
      BARS(:, 4*K + 2) = (/ 2 + K, 2 + MOD(K + 1, 6) /)
      BARS(:, 4*K + 3) = (/ 2 + K, 8 + K /)
      BARS(:, 4*K + 4) = (/ 2 + K, 8 + MOD(K + 5, 6) /)
    END DO
  END SUBROUTINE BUILD
END MODULE DOME

SUBROUTINE FUNC(NDIM, U, ICP, PAR, IJAC, F, DFDU, DFDP)
  USE DOME
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), IJAC
  DOUBLE PRECISION, INTENT(IN) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(OUT) :: F(NDIM)
  DOUBLE PRECISION, INTENT(INOUT) :: DFDU(NDIM, NDIM), DFDP(NDIM, *)
  DOUBLE PRECISION :: X(3, 13), LOAD(21), D(3), FORCE(3), L, TENSION
  DOUBLE PRECISION :: M(3, 3) ! derivatives
  INTEGER :: A, B, I, J, K
  LOAD = 0
  LOAD(3:21:3) = -1.d-3
  LOAD(3) = -0.5d-3
  X = NODES
  X(:, 1:7) = X(:, 1:7) + RESHAPE(U, (/ 3, 7 /))
  F = -PAR(1)*LOAD
  IF (IJAC > 0) DFDU = 0 ! derivatives
  IF (IJAC > 1) DFDP(:, 1) = -LOAD ! derivatives
  DO K = 1, 24
    A = BARS(1, K)
    B = BARS(2, K)
    L = NORM2(NODES(:, B) - NODES(:, A))
    D = X(:, B) - X(:, A)
    TENSION = (DOT_PRODUCT(D, D) - L**2)/(2*L**3)
    FORCE = TENSION*D
    I = 3*A - 2
    J = 3*B - 2
    F(I:I+2) = F(I:I+2) - FORCE
    IF (B <= 7) F(J:J+2) = F(J:J+2) + FORCE
    IF (IJAC == 0) CYCLE ! derivatives
    M = SPREAD(D, 2, 3)*SPREAD(D, 1, 3)/L**3 ! derivatives
    M(1, 1) = M(1, 1) + TENSION ! derivatives
    M(2, 2) = M(2, 2) + TENSION ! derivatives
    M(3, 3) = M(3, 3) + TENSION ! derivatives
    DFDU(I:I+2, I:I+2) = DFDU(I:I+2, I:I+2) + M ! derivatives
    IF (B > 7) CYCLE ! derivatives
    DFDU(J:J+2, J:J+2) = DFDU(J:J+2, J:J+2) + M ! derivatives
    DFDU(I:I+2, J:J+2) = DFDU(I:I+2, J:J+2) - M ! derivatives
    DFDU(J:J+2, I:I+2) = DFDU(J:J+2, I:I+2) - M ! derivatives
  END DO
END SUBROUTINE FUNC

SUBROUTINE STPNT(NDIM, U, PAR, T)
  USE DOME
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  DOUBLE PRECISION, INTENT(INOUT) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(IN) :: T
  CALL BUILD
  U = 0
  PAR(1) = 0
END SUBROUTINE STPNT

SUBROUTINE BCND
END SUBROUTINE BCND
SUBROUTINE ICND
END SUBROUTINE ICND
SUBROUTINE FOPT
END SUBROUTINE FOPT
SUBROUTINE PVLS
END SUBROUTINE PVLS
